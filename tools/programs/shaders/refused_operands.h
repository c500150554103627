// Operands that HLSL refuses and glslang takes, for which it makes SPIR-V that is not valid or means
// something else. Internal to this room.
#pragma once

#include <glslang/Include/intermediate.h>

#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Floats as operands of & | ^ << >> (FXC X3082), and a Load with another number of coordinates than its
// texture takes (FXC X3017): of several numbers, glslang takes the last for the mip level.
std::vector<ModuleProblem> refused_operands(const glslang::TIntermediate& tree);

}  // namespace penumbra::shaders
