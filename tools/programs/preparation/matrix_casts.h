// A whole number or bool made a matrix of floats, `(float4x4)0` and `float3x3(1)`. glslang 12 folds the
// conversion and leaves every element but the first few unset: the module holds whatever the memory held
// before, another number in another run, and nothing says so. The number is made a float first,
// `(float4x4)(float)0`, which folds as it should.
//
// Literals with their sign, true and false, and names of scalars; what is computed when the shader runs was
// right before and stays so.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void widen_matrix_casts(TokenText& text);

}  // namespace penumbra::preparation
