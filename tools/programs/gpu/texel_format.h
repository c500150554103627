// The formats of this folder as Vulkan's, as far as a device has them. Internal to this folder.
#pragma once

#include <optional>

#include "gpu/device_state.h"
#include "gpu/format.h"

namespace penumbra::gpu {

struct TexelFormat {
  vk::Format format = vk::Format::eUndefined;
  vk::ImageAspectFlags aspects;    // all the image has
  vk::ImageAspectFlagBits copied;  // the one shaders and copies see
  vk::ImageUsageFlags usage;       // all that the device has for it
};

// Empty when no form of it can be sampled and copied here, and a depth format drawn to. depth24 may be either
// of two.
std::optional<TexelFormat> texel_format_of(const DeviceState& device, Format format);

// The same; throws EnvironmentError instead.
TexelFormat need_texel_format(const DeviceState& device, Format format);

FormatUses uses_of(const DeviceState& device, Format format);

}  // namespace penumbra::gpu
