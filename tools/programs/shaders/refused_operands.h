// Operands that HLSL rejects and glslang accepts, emitting invalid SPIR-V or code with another meaning.
// Internal to this folder.
#pragma once

#include <glslang/Include/intermediate.h>

#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Finds floats as operands of & | ^ << >> (FXC X3082), and a Load with too few or too many coordinates for
// its texture (FXC X3017): glslang treats the last of several as the mip level.
std::vector<hlsl::Diagnostic> refused_operands(const glslang::TIntermediate& tree);

}  // namespace penumbra::shaders
