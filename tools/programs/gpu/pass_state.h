#pragma once

#include <functional>

#include "gpu/bindings.h"
#include "gpu/compute_pass.h"
#include "gpu/pass_interface.h"
#include "gpu/raster_pass.h"
#include "gpu/resource_uses.h"
#include "gpu/sequence.h"

namespace penumbra::gpu {

// The Vulkan side of Bindings: descriptors.
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

// The steps that passes add to a submission.
struct SequenceStep {
  ResourceUses uses;
  std::shared_ptr<BindingsState> bindings;  // null if there are none
  std::uint64_t revision = 0;               // revision of the bindings
  vk::PipelineBindPoint point = vk::PipelineBindPoint::eCompute;
  std::function<void(const vk::raii::CommandBuffer&)> record;
  std::shared_ptr<void> used;  // kept alive
};

struct SequenceState {
  std::shared_ptr<DeviceState> device;
  std::vector<SequenceStep> steps;
  std::vector<bool> waited;
};

// Returns the step without its `record`; throws std::logic_error for bindings of another pass, and for empty
// ones.
SequenceStep step_with(const Bindings& bindings, const PassInterface& interface, vk::PipelineBindPoint point);

// The Vulkan side of a ComputePass.
struct ComputeState {
  std::shared_ptr<PassInterface> interface;
  ComputeShader shader;

  vk::Pipeline pipeline();  // made when first needed

 private:
  vk::raii::Pipeline pipeline_ = nullptr;
};

// The Vulkan side of a RasterPass.
struct RasterState {
  std::shared_ptr<PassInterface> interface;
  RasterShaders shaders;
  vk::raii::RenderPass render_pass = nullptr;

  vk::Pipeline pipeline();  // made when first needed

 private:
  vk::raii::Pipeline pipeline_ = nullptr;
};

SequenceStep raster_step(const std::shared_ptr<RasterState>& pass, const Bindings& bindings,
                         const RasterTargets& targets, const std::vector<RasterTile>& tiles,
                         const VertexStreams& streams);

}  // namespace penumbra::gpu
