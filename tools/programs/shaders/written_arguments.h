// Arguments of out and inout parameters that are not lvalues: `F(1.0)` and `F(a + b)` for `void F(out float
// x)`. HLSL rejects them (FXC X3025, X3013); glslang accepts them, and crashes or emits an invalid module. It
// does the same for an inout argument of another type, which HLSL allows. Internal to this folder.
#pragma once

#include <glslang/Include/intermediate.h>

#include <vector>

#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {

// Finds constants, results of operators and conversions, in the whole syntax tree; other expressions that are
// not lvalues are not reported.
std::vector<hlsl::Diagnostic> unwritable_arguments(const glslang::TIntermediate& tree);

}  // namespace penumbra::shaders
