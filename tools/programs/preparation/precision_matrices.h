// Matrices of minimum precision, `min16float3x3`, which glslang's front end does not know although it knows
// the scalars and vectors: `half3x3` expands to one on mobile targets. They become `half3x3`, and matrices of
// min16int, min12int and min16uint those of int and uint.
//
// Minimum precision permits more bits (docs.microsoft.com/windows/win32/direct3dhlsl/
// using-hlsl-minimum-precision), and half is float here, so the requested precision is met.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void name_precision_matrices(TokenText& text);

}  // namespace penumbra::preparation
