// Rules negative-pow and nan-check. Internal to this folder.
//
// Direct3D's compiler warns that pow(f, e) gives NaN for negative f wherever it cannot prove f >= 0 (X3571),
// and that isnan() may be removed because it assumes that no value is NaN (X3577); GLSL's pow is undefined
// for negative bases (GLSL 4.60 specification, 8.2).
// https://learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-pow
#pragma once

#include <vector>

#include "lint/source_place.h"

namespace penumbra::lint {

// `linted` is a legalised module.
std::vector<hlsl::Diagnostic> arithmetic_findings(const LintedCode& linted);

}  // namespace penumbra::lint
