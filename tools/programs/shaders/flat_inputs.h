// Integer inputs of a fragment shader are not interpolated, whether the source says so or not
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-struct), and SPIR-V for Vulkan requires the
// decoration Flat (VUID-StandaloneSpirv-Flat-04744). glslang omits it for members of nested structs.
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Decorates the integer inputs of fragment entry points that lack it.
void flatten_integer_inputs(SpirvModule& module);

}  // namespace penumbra::shaders
