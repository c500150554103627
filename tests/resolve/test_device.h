// One device for all tests of a program; its validation layers must have stayed silent.
#pragma once

#include <gtest/gtest.h>

#include "gpu/device.h"
#include "platform/data_directory.h"
#include "shaders/technique_list.h"

namespace penumbra {

inline gpu::Device& test_device() {
  static gpu::Device device({.name = {}, .validation = true, .timeout_seconds = 600.0});
  return device;
}

inline const shaders::TechniqueList& library_techniques() {
  static const shaders::TechniqueList list =
      shaders::read_technique_list(platform::data_directory() / "ShaderLibrary" / "techniques.json");
  return list;
}

class SilentValidation : public testing::Environment {
 public:
  void SetUp() override { test_device(); }  // so that it outlives what the tests keep of it
  void TearDown() override {
    for (const std::string& message : test_device().validation_log()->messages()) ADD_FAILURE() << message;
  }
};

}  // namespace penumbra
