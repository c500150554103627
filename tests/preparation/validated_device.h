// The device of these tests has Vulkan's validation layers.
#pragma once

#include "gpu/device.h"

namespace penumbra::preparation {

inline gpu::Device& device() {
  static gpu::Device shared({.name = "", .validation = true});
  return shared;
}

}  // namespace penumbra::preparation
