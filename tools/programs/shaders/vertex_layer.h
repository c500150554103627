// A stage before the rasteriser, other than the geometry stage, that chooses the layer it draws to
// (SV_RenderTargetArrayIndex), as a vertex shader does when both eyes are drawn at once by instancing.
// Internal to this room.
//
// Vulkan and Metal have it. OpenGL has it with GL_ARB_shader_viewport_layer_array, ESSL has it with no
// extension that can be counted on, and Direct3D 11 has it where
// VPAndRTArrayIndexFromAnyShaderFeedingRasterizer is (Direct3D 11.3); SPIRV-Cross asks for no extension and
// refuses it for HLSL. Source: ARB_shader_viewport_layer_array; Microsoft, D3D11_FEATURE_DATA_D3D11_OPTIONS3.
#pragma once

#include <string>

#include "shaders/cross_compile.h"
#include "shaders/spirv_cross_session.h"

namespace penumbra::shaders {

class VertexLayer {
 public:
  // Before the module is compiled. Throws std::invalid_argument where the target cannot say it.
  VertexLayer(const SpirvCrossSession& session, Target target);

  // What SPIRV-Cross could not write itself, in the text it emitted.
  std::string completed(std::string text) const;

 private:
  std::string stand_in_;  // the semantic the layer is emitted with; empty: its own
};

}  // namespace penumbra::shaders
