// Arguments that a function writes to and that cannot be written to: `F(1.0)` and `F(a + b)` for
// `void F(out float x)`. HLSL refuses them (FXC X3025, X3013); glslang takes them, and crashes or makes an
// invalid module when it generates SPIR-V. So it does for an inout argument of another type, which HLSL
// allows. Internal to this room.
#pragma once

#include <glslang/Include/intermediate.h>

#include <vector>

#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {

// Constants, results of operators and conversions, in the whole tree; what else may not be written to is not
// told.
std::vector<ModuleProblem> unwritable_arguments(const glslang::TIntermediate& tree);

}  // namespace penumbra::shaders
