// A device with validation on, and shaders of tests/gpu/shaders bound by name.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "gpu/compute_pass.h"
#include "gpu/device.h"
#include "gpu/raster_pass.h"
#include "shaders/compile.h"

namespace penumbra::gpu {

inline std::vector<std::uint32_t> compile_test_shader(const std::string& file,
                                                      const std::string& entry = "Main",
                                                      hlsl::Stage stage = hlsl::Stage::compute) {
  shaders::CompileRequest request;
  request.file = std::string(PENUMBRA_SOURCE_DIR "/tests/gpu/shaders/") + file;
  request.entry = entry;
  request.stage = stage;
  const shaders::CompileResult result = shaders::compile(request);
  std::string messages;
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) messages += hlsl::format(diagnostic) + "\n";
  if (result.spirv.empty()) throw std::runtime_error(messages);
  return result.spirv;
}

// Every test runs with the validation layers on, and fails when they spoke, at teardown too.
class Gpu : public testing::Test {
 protected:
  void SetUp() override {
    device.emplace(DeviceOptions{.name = "", .validation = true});
    log = device->validation_log();
  }
  void TearDown() override {
    device.reset();
    ASSERT_TRUE(log) << "no device was opened";
    EXPECT_THAT(log->messages(), testing::IsEmpty());
  }

  std::optional<Device> device;
  std::shared_ptr<const ValidationLog> log;
};

// The names of all formats a test parameter can take.
inline std::string format_name(const testing::TestParamInfo<Format>& info) {
  return name(info.param);
}

}  // namespace penumbra::gpu
