// Operators between matrices, which HLSL applies element by element
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-per-component-math).
//
// `m * n` and `m *= n`: glslang multiplies the matrices as mul() does, without a word. A function that
// multiplies row by row takes the place of the operator; where the type of one operand is not known, an
// overload is found by the compiler for what it turns out to be, matrix or scalar.
//
// `(float3x3)m + n` with n a float4x4: HLSL leaves away the rows and columns that the smaller one has not
// (warning X3206), glslang refuses to combine the two. The larger one is cast to the type of the smaller.
//
// One operand at least must be a name, member, element or call whose type is known (value_types.h), a cast or
// a constructor of a matrix, or be made of such by parentheses, operators, mul() and transpose(). Linear
// time.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_matrix_operators(TokenText& text);

}  // namespace penumbra::preparation
