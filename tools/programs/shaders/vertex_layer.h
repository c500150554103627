// A stage before the rasteriser, other than the geometry stage, that selects the layer it draws to
// (SV_RenderTargetArrayIndex), as a vertex shader does if both eyes are drawn at once by instancing. Internal
// to this folder.
//
// Vulkan and Metal support it. OpenGL supports it with GL_ARB_shader_viewport_layer_array, ESSL with no
// widely available extension, and Direct3D 11 if VPAndRTArrayIndexFromAnyShaderFeedingRasterizer is set
// (Direct3D 11.3); SPIRV-Cross requests no extension and rejects it for HLSL. Source:
// ARB_shader_viewport_layer_array; Microsoft, D3D11_FEATURE_DATA_D3D11_OPTIONS3.
#pragma once

#include <string>

#include "shaders/cross_compile.h"
#include "shaders/spirv_cross_session.h"

namespace penumbra::shaders {

class VertexLayer {
 public:
  // The object must be made before the module is compiled. Throws std::invalid_argument if the target cannot
  // express it.
  VertexLayer(const SpirvCrossSession& session, Target target);

  // Adds to the emitted text the parts that SPIRV-Cross could not write itself.
  std::string completed(std::string text) const;

 private:
  std::string stand_in_;  // the semantic with which the layer is emitted; empty for its own
};

}  // namespace penumbra::shaders
