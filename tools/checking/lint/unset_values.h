// Rules output-not-set and read-before-set. Internal to this room.
//
// Direct3D's compiler refuses a function some path of which returns nothing (X3507) and an out parameter that
// is not completely set (X3508); it warns of a shader output that is not (X3578) and of variables that may be
// read before they are set (X4000). glslang passes all four.
// https://learn.microsoft.com/windows/win32/direct3dhlsl/hlsl-errors-and-warnings
#pragma once

#include <vector>

#include "lint/rule.h"
#include "lint/source_place.h"

namespace penumbra::lint {

// The module must have kept its functions and names (unoptimised).
std::vector<Finding> unset_values(const LintedCode& linted);

}  // namespace penumbra::lint
