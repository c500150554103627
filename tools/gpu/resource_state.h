// The Vulkan side of buffers, images and samplers, for this room's sources only.
#pragma once

#include "gpu/device_state.h"
#include "gpu/resources.h"
#include "gpu/texel_format.h"

namespace penumbra::gpu {

struct BufferState {
  std::shared_ptr<DeviceState> device;
  Allocation allocation;
};

struct ImageState {
  std::shared_ptr<DeviceState> device;
  Format format = Format::r32f;
  vk::Extent2D extent;
  TexelFormat texel;
  vk::raii::DeviceMemory memory = nullptr;
  vk::raii::Image image = nullptr;
  vk::raii::ImageView shader_view = nullptr;  // of the aspect shaders read
  vk::raii::ImageView target_view = nullptr;  // of all aspects, as render passes ask
  vk::ImageLayout layout = vk::ImageLayout::eUndefined;

  void move_to(vk::ImageLayout wanted, const vk::raii::CommandBuffer& commands);
};

struct SamplerState {
  std::shared_ptr<DeviceState> device;
  vk::raii::Sampler sampler = nullptr;
};

}  // namespace penumbra::gpu
