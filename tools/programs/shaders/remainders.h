// The result of % and fmod has the sign of the dividend in HLSL: (-7) % 2 is -1. glslang emits the
// instructions of GLSL's mod(), whose result has the sign of the divisor.
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// OpFMod becomes OpFRem. OpSMod a, b becomes a - b * (a / b): Vulkan leaves OpSRem and OpSMod of negative
// numbers undefined, and OpSDiv truncates.
void truncate_remainders(SpirvModule& module);

}  // namespace penumbra::shaders
