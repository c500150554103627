// The Vulkan side of Bindings, for this room's sources only: descriptors, and the layouts they imply.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "gpu/bindings.h"
#include "gpu/resource_state.h"

namespace penumbra::gpu {

struct BoundResource {
  vk::DescriptorType type = vk::DescriptorType::eStorageBuffer;
  std::shared_ptr<BufferState> buffer;
  std::shared_ptr<ImageState> image;
  std::shared_ptr<SamplerState> sampler;
  Allocation uniforms;
};

struct BindingsState {
  std::shared_ptr<DeviceState> device;
  std::map<std::pair<std::uint32_t, std::uint32_t>, BoundResource> slots;  // by set, binding
  std::vector<vk::raii::DescriptorSetLayout> layouts;                      // one per set, gaps included
  vk::raii::DescriptorPool pool = nullptr;
  std::vector<vk::raii::DescriptorSet> sets;
  vk::raii::PipelineLayout pipeline_layout = nullptr;
  bool changed = true;  // slots differ from what the descriptor sets say

  // Fixes which slots there are and makes layouts and sets; from then on slots only change their resource.
  void freeze(vk::ShaderStageFlags stages, std::uint32_t push_constant_bytes);
  bool frozen() const { return bool(*pipeline_layout); }

  void write_descriptors();
  // Brings images into the layouts the slots read them in, and binds the sets.
  void use(vk::PipelineBindPoint point, const vk::raii::CommandBuffer& commands);

  BoundResource& slot(Slot slot, vk::DescriptorType type);
};

// Throws std::logic_error naming the resource when the shader reads a slot that holds nothing, or another
// kind.
void require_bound(const BindingsState& bindings, const std::vector<std::uint32_t>& spirv);

}  // namespace penumbra::gpu
