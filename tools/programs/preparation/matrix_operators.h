// Operators between matrices, which HLSL applies element by element
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-per-component-math).
//
// `m * n` and `m *= n`: glslang silently multiplies the matrices as mul() does. The operator is replaced by a
// function that multiplies row by row; if the type of one operand is unknown, overload resolution selects the
// matrix or the scalar version.
//
// `(float3x3)m + n` with n a float4x4: HLSL drops the rows and columns that the smaller matrix does not have
// (warning X3206), glslang reports an error. The larger one is cast to the type of the smaller.
//
// At least one operand must be a name, member, element or call whose type is known (value_types.h), a cast or
// constructor of a matrix, or composed of these by parentheses, operators, mul() and transpose(). Linear
// time.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_matrix_operators(TokenText& text);

}  // namespace penumbra::preparation
