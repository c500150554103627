// Rules divergent-derivative, gradient-in-varying-loop and unroll-without-bound. Internal to this folder.
//
// Implicit derivatives (Sample, SampleCmp, SampleBias, ddx, ddy, fwidth, CalculateLevelOfDetail) are only
// defined in uniform control flow within a quad (SPIR-V specification, "Derivatives"). Direct3D's compiler
// moves such an operation out of a divergent condition with a warning (X4121) and unrolls a loop around it
// with a divergent number of iterations (X3570), which fails if nothing bounds the iterations (X3511).
// https://learn.microsoft.com/windows/win32/direct3dhlsl/hlsl-errors-and-warnings
#pragma once

#include <vector>

#include "lint/source_place.h"

namespace penumbra::lint {

// `linted` is a legalised fragment shader.
std::vector<hlsl::Diagnostic> gradient_findings(const LintedCode& linted);

// Finds loops marked [unroll] without a constant bound, in any legalised stage.
std::vector<hlsl::Diagnostic> unroll_findings(const LintedCode& linted);

}  // namespace penumbra::lint
