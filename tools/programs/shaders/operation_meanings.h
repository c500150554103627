// Calls of intrinsic functions for which glslang's SPIR-V back end emits instructions with another meaning
// than in HLSL. They are corrected in the syntax tree, where the types of the arguments are known. Internal
// to this folder.
//
// - abs(u) of an unsigned integer is u; the back end treats it as signed.
// - mad(a, b, c) is a * b + c, also for integers, for which there is no Fma. HLSL does not specify whether it
//   rounds once or twice.
// - -u of an unsigned integer is 0 - u: SPIRV-Tools 2023.1 folds -(u / 2) to u / -2.
// - ldexp(x, e) with a float e is x * exp2(e); Ldexp takes integer exponents.
#pragma once

#include <glslang/Include/intermediate.h>

namespace penumbra::shaders {

void correct_operations(glslang::TIntermediate& tree);

}  // namespace penumbra::shaders
