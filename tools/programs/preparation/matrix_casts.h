// An integer or bool cast to a float matrix, `(float4x4)0` and `float3x3(1)`. glslang 12 folds the conversion
// and silently leaves every element but the first few uninitialised: their values differ between runs. The
// number is cast to float first, `(float4x4)(float)0`, which is folded correctly.
//
// Applies to literals with their sign, true and false, and names of scalars; glslang converts run-time values
// correctly.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void widen_matrix_casts(TokenText& text);

}  // namespace penumbra::preparation
