// Rules output-not-set and read-before-set. Internal to this folder.
//
// Direct3D's compiler rejects a function with a path that returns nothing (X3507) and an out parameter that
// is not completely assigned (X3508); it warns about a shader output that is not (X3578) and about variables
// that may be read uninitialised (X4000). glslang accepts all four.
// https://learn.microsoft.com/windows/win32/direct3dhlsl/hlsl-errors-and-warnings
#pragma once

#include <vector>

#include "lint/source_place.h"

namespace penumbra::lint {

// The module must have its functions and names (unoptimised).
std::vector<hlsl::Diagnostic> unset_values(const LintedCode& linted);

}  // namespace penumbra::lint
