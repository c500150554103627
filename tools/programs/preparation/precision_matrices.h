// Matrices of minimum precision, `min16float3x3`, which glslang's front end does not know although it knows
// the scalars and vectors: `half3x3` is one on mobile targets. They become `half3x3`, and matrices of
// min16int, min12int and min16uint those of int and uint.
//
// Minimum precision allows more bits than it names (docs.microsoft.com/windows/win32/direct3dhlsl/
// using-hlsl-minimum-precision), and half is float or 16 bits wide here as the options say, so the values
// stay within what the shader asked for.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void name_precision_matrices(TokenText& text);

}  // namespace penumbra::preparation
