// The Vulkan side of buffers, images and samplers. Internal to this folder.
#pragma once

#include <compare>
#include <map>

#include "gpu/device_state.h"
#include "gpu/resources.h"
#include "gpu/texel_format.h"

namespace penumbra::gpu {

struct BufferState {
  std::shared_ptr<DeviceState> device;
  Allocation allocation;
};

// Mip levels and layers of an image.
struct ImageParts {
  int first_mip = 0;
  int mips = 1;
  int first_layer = 0;
  int layers = 1;

  auto operator<=>(const ImageParts&) const = default;
};

struct ImageState {
  std::shared_ptr<DeviceState> device;
  ImageShape shape;
  TexelFormat texel;
  vk::raii::DeviceMemory memory = nullptr;
  vk::raii::Image image = nullptr;
  std::vector<vk::ImageLayout> layouts;  // layer by layer of mip level 0, then of 1, ...

  ImageParts whole() const { return {0, shape.mips, 0, shape.layers}; }
  vk::Extent3D extent(int mip) const;
  vk::ImageLayout& layout(int mip, int layer);
  vk::ImageSubresourceRange range(const ImageParts& parts) const;  // the parts in all aspects

  // The view is as shaders read it, or as a target with all aspects; it is kept.
  vk::ImageView view(const ImageParts& parts, vk::ImageViewType type, bool target);

 private:
  struct ViewKey {
    ImageParts parts;
    vk::ImageViewType type;
    bool target;
    auto operator<=>(const ViewKey&) const = default;
  };
  std::map<ViewKey, vk::raii::ImageView> views_;
};

struct SamplerState {
  std::shared_ptr<DeviceState> device;
  vk::raii::Sampler sampler = nullptr;
};

}  // namespace penumbra::gpu
