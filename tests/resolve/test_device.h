// All tests of a program share one device, and what they keep on it; its validation layers must have stayed
// silent.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "gpu/device.h"
#include "platform/data_directory.h"
#include "techniques/technique_list.h"

namespace penumbra {

// Opens the device when a test asks for it, and closes it behind the last one.
class TestDevice : public testing::Environment {
 public:
  gpu::Device& open() {
    if (!device_)
      device_.emplace(gpu::DeviceOptions{.name = {}, .validation = true, .timeout_seconds = 600.0});
    return *device_;
  }

  void before_it_closes(std::function<void()> work) { before_it_closes_.push_back(std::move(work)); }

  void TearDown() override {
    if (!device_) return;
    for (const std::function<void()>& work : before_it_closes_) work();
    const std::shared_ptr<const gpu::ValidationLog> log = device_->validation_log();
    device_.reset();
    for (const std::string& message : log->messages()) ADD_FAILURE() << message;
  }

 private:
  std::optional<gpu::Device> device_;
  std::vector<std::function<void()>> before_it_closes_;
};

inline TestDevice* const kTestDevice = [] {
  auto* const environment = new TestDevice;
  testing::AddGlobalTestEnvironment(environment);  // the environment owns it
  return environment;
}();

inline gpu::Device& test_device() {
  return kTestDevice->open();
}

// Passes and the like that tests share, because building a pipeline costs more than running it: a static
// where they are made, empty before the device closes.
template <typename Values>
class KeptOnDevice {
 public:
  KeptOnDevice() {
    kTestDevice->before_it_closes([this] { values_.emplace(); });
  }
  KeptOnDevice(const KeptOnDevice&) = delete;
  KeptOnDevice& operator=(const KeptOnDevice&) = delete;

  Values& operator*() { return *values_; }
  Values* operator->() { return &*values_; }

 private:
  std::optional<Values> values_{std::in_place};
};

// The library's techniques, and the variants of them that studies measure.
inline const techniques::TechniqueList& library_techniques() {
  static const techniques::TechniqueList list = techniques::read_technique_list(
      std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests/study/StudyVariants.technique.json");
  return list;
}

}  // namespace penumbra
