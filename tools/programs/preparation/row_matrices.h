// Matrices of one row or one column, float1x3 and float4x1: "Cannot construct this type" to glslang, for
// SPIR-V has none of less than two columns or rows. They become vectors: `m[0][2]` and `m._m02` of a float1x3
// are its component z, `m[2]` of a float3x1 is a number, and mul() takes a vector for a row on its left and
// for a column on its right, which is what they are.
//
// An error: mul() of a column and a row, whose matrix glslang would make a number, and such a matrix in a
// constant buffer, where each of its columns has a register of its own.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void make_row_matrices_vectors(TokenText& text);

}  // namespace penumbra::preparation
