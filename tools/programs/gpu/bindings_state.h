// The Vulkan side of Bindings: descriptors. Internal to this folder.
#pragma once

#include <vector>

#include "gpu/bindings.h"
#include "gpu/pass_interface.h"
#include "gpu/resource_uses.h"

namespace penumbra::gpu {

struct BoundResource {
  std::shared_ptr<BufferState> buffer;
  std::shared_ptr<ImageState> image;
  ImageParts parts;
  std::shared_ptr<SamplerState> sampler;
  std::shared_ptr<Allocation> uniforms;

  bool empty() const { return !buffer && !image && !sampler && !uniforms; }
};

struct BindingsState {
  std::shared_ptr<PassInterface> interface;
  std::vector<BoundResource> bound;  // in the order of the interface's slots
  vk::raii::DescriptorPool pool = nullptr;
  std::vector<vk::raii::DescriptorSet> sets;
  bool changed = true;         // true if slots differ from the descriptor sets
  std::uint64_t revision = 0;  // grows when a slot gets another resource

  // Throws std::logic_error naming the resource to which nothing is bound.
  void require_bound() const;
  void write_descriptors();
  void use(vk::PipelineBindPoint point, const vk::raii::CommandBuffer& commands) const;
  void add_uses(ResourceUses& uses) const;

 private:
  void make_sets();
};

}  // namespace penumbra::gpu
