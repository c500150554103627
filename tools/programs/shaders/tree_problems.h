#pragma once

#include <glslang/Include/intermediate.h>

#include "shaders/spirv_module.h"
#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {

// Reads without comparison through a comparison sampler. HLSL has no such overload; glslang accepts them and
// treats the next argument as the comparison reference, or crashes if there is none.
//
// Finds them in the whole syntax tree, because SPIR-V is generated for all of it.
std::vector<hlsl::Diagnostic> reads_without_comparing(const glslang::TIntermediate& tree);

// Arguments of out and inout parameters that are not lvalues: `F(1.0)` and `F(a + b)` for `void F(out float
// x)`. HLSL rejects them (FXC X3025, X3013); glslang accepts them, and crashes or emits an invalid module. It
// does the same for an inout argument of another type, which HLSL allows.
//
// Finds constants, results of operators and conversions, in the whole syntax tree; other expressions that are
// not lvalues are not reported.
std::vector<hlsl::Diagnostic> unwritable_arguments(const glslang::TIntermediate& tree);

// Operands that HLSL rejects and glslang accepts, emitting invalid SPIR-V or code with another meaning.
//
// Finds floats as operands of & | ^ << >> (FXC X3082), and a Load with too few or too many coordinates for
// its texture (FXC X3017): glslang treats the last of several as the mip level.
std::vector<hlsl::Diagnostic> refused_operands(const glslang::TIntermediate& tree);

// Calls of intrinsic functions for which glslang's SPIR-V back end emits instructions with another meaning
// than in HLSL. They are corrected in the syntax tree, where the types of the arguments are known.
//
// - abs(u) of an unsigned integer is u; the back end treats it as signed.
// - mad(a, b, c) is a * b + c, also for integers, for which there is no Fma. HLSL does not specify whether it
//   rounds once or twice.
// - -u of an unsigned integer is 0 - u: SPIRV-Tools 2023.1 folds -(u / 2) to u / -2.
// - ldexp(x, e) with a float e is x * exp2(e); Ldexp takes integer exponents.
void correct_operations(glslang::TIntermediate& tree);

}  // namespace penumbra::shaders
