// Whole numbers that a fragment shader receives are not interpolated, whether the source says so or not
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-struct), and SPIR-V for Vulkan asks that
// they be decorated Flat (VUID-StandaloneSpirv-Flat-04744). glslang forgets it for members of structs in
// structs.
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Decorates the integer inputs of fragment entry points that are not yet.
void flatten_integer_inputs(SpirvModule& module);

}  // namespace penumbra::shaders
