// The formats of this folder as Vulkan's, as far as a device has them. Internal to this folder.
#pragma once

#include "gpu/device_state.h"
#include "gpu/format.h"

namespace penumbra::gpu {

struct TexelFormat {
  vk::Format format = vk::Format::eUndefined;
  vk::ImageAspectFlags aspects;    // all aspects of the image
  vk::ImageAspectFlagBits copied;  // the aspect that shaders and copies see
  vk::ImageUsageFlags usage;       // all uses of it that the device supports
};

// The result is empty when no form of the format can be sampled and copied here, and, if it is a depth
// format, drawn to. depth24 may be either of two.
std::optional<TexelFormat> texel_format_of(const DeviceState& device, Format format);

// Returns the same; throws EnvironmentError instead.
TexelFormat need_texel_format(const DeviceState& device, Format format);

FormatUses uses_of(const DeviceState& device, Format format);

}  // namespace penumbra::gpu
