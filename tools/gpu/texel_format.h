// This room's formats in Vulkan's words, as far as a device has them.
#pragma once

#include <optional>

#include "gpu/device_state.h"
#include "gpu/format.h"

namespace penumbra::gpu {

struct TexelFormat {
  vk::Format format = vk::Format::eUndefined;
  vk::ImageAspectFlags aspects;    // all the image has
  vk::ImageAspectFlagBits copied;  // the one shaders and copies see
  vk::ImageUsageFlags usage;
};

// Empty when no form of it can be sampled, rendered to and copied here. depth24 may be either of two.
std::optional<TexelFormat> texel_format_of(const DeviceState& device, Format format);

}  // namespace penumbra::gpu
