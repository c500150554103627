// The Vulkan side of a RasterPass. Internal to this folder.
#pragma once

#include "gpu/pass_interface.h"
#include "gpu/raster_pass.h"
#include "gpu/sequence_state.h"

namespace penumbra::gpu {

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
