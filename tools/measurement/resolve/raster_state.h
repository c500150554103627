// A pass's render state commands as the harness draws them. Internal to this folder.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gpu/raster_pass.h"
#include "shaderlab/programs.h"

namespace penumbra::resolve {

// The state that a pass's render state decides; the runner decides the rest.
struct RasterState {
  bool both_faces = false;
  gpu::DepthTest depth_test = gpu::DepthTest::less_equal;
  bool depth_write = true;
  bool depth_clamp = false;
  std::optional<gpu::StencilState> stencil;
  float constant_depth_bias = 0.0F;
  float slope_depth_bias = 0.0F;
  std::vector<gpu::Blend> blends;  // one for each target
};

// The presence of a stencil in the targets.
enum class StencilTarget { none, has };

// Commands that are absent get Unity's defaults. `pass` is the name in messages, followed by the line. Throws
// InputError for a state that is drawn in Unity but not here.
RasterState raster_state(const std::vector<shaderlab::RenderCommand>& commands, const std::string& pass,
                         std::size_t targets, bool reversed_z, StencilTarget stencil = StencilTarget::none);

}  // namespace penumbra::resolve
