// The functions any(x) and all(x) of a scalar, which HLSL has
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-any). glslang emits OpAny and OpAll for
// them, which only accept vectors (SPIR-V specification 3.42.15); for a single bool the result is that bool.
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Replaces OpAny and OpAll of one bool by OpCopyObject.
void copy_scalar_conditions(SpirvModule& module);

}  // namespace penumbra::shaders
