#pragma once

#include "shaders/cross_compile.h"
#include "shaders/spirv_cross_session.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// SPIRV-Cross copies a value of another precision before it reads it, `mediump int mp_copy_7 = _7;`. A
// loop-carried value is copied at the head of the loop, inside its braces, and the copy is also read after
// the loop, where it is out of scope (SPIRV-Cross as of Debian 12). Such a text is detected here; no copies
// are made for a module without relaxed precision.
//
// Returns whether the text reads a precision copy whose declaration is out of scope.
bool reads_lost_copy(std::string_view essl);

// Returns the module with everything in full precision, which relaxed precision allows (SPIR-V specification,
// 3.20: RelaxedPrecision).
SpirvModule without_relaxed_precision(const SpirvModule& module);

// GatherCmp for HLSL: Direct3D 11 has it (shader model 5), SPIRV-Cross rejects it ("GatherCmp does not exist
// in HLSL"). It is emitted as SampleCmpLevelZero, which takes the same arguments, with an offset that no
// shader can have; then its name and offset are corrected in the text.
//
// Returns the module for SPIRV-Cross; nothing if it has no such gather, or one whose offset is not constant.
std::optional<SpirvModule> with_marked_gathers(const SpirvModule& module);

// Restores the gathers in the text emitted for that module.
std::string with_named_gathers(std::string hlsl);

// A stage before the rasteriser, other than the geometry stage, that selects the layer it draws to
// (SV_RenderTargetArrayIndex), as a vertex shader does if both eyes are drawn at once by instancing.
//
// Vulkan and Metal support it. OpenGL supports it with GL_ARB_shader_viewport_layer_array, ESSL with no
// widely available extension, and Direct3D 11 if VPAndRTArrayIndexFromAnyShaderFeedingRasterizer is set
// (Direct3D 11.3); SPIRV-Cross requests no extension and rejects it for HLSL. Source:
// ARB_shader_viewport_layer_array; Microsoft, D3D11_FEATURE_DATA_D3D11_OPTIONS3.
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
