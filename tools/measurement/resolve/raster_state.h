// A pass's render state commands as the harness draws them. Internal to this folder.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gpu/raster_pass.h"
#include "shaderlab/render_commands.h"

namespace penumbra::resolve {

// What of a pass's render state is left to it; the rest is the runner's.
struct RasterState {
  bool both_faces = false;
  gpu::DepthTest depth_test = gpu::DepthTest::less_equal;
  bool depth_write = true;
  bool depth_clamp = false;
  std::optional<gpu::StencilState> stencil;
  float constant_depth_bias = 0.0F;
  float slope_depth_bias = 0.0F;
  std::vector<gpu::Blend> blends;  // of each of the targets
};

// Whether what is drawn into has a stencil.
enum class StencilTarget { none, has };

// With Unity's defaults for commands that are not there. `pass`: what messages call it, followed by the line.
// Throws InputError for a state that is drawn in Unity but not here.
RasterState raster_state(const std::vector<shaderlab::RenderCommand>& commands, const std::string& pass,
                         std::size_t targets, bool reversed_z, StencilTarget stencil = StencilTarget::none);

}  // namespace penumbra::resolve
