// Static variables without an initialiser are zero in HLSL
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-variable-syntax). glslang leaves them
// undefined.
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Private variables get a null constant as their initialiser if their type has one: all except those that
// contain textures, samplers or buffers.
void zero_statics(SpirvModule& module);

}  // namespace penumbra::shaders
