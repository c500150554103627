// Matrices with one row or one column, float1x3 and float4x1: "Cannot construct this type" in glslang,
// because SPIR-V requires at least two columns and rows. They become vectors: `m[0][2]` and `m._m02` of a
// float1x3 become component z, `m[2]` of a float3x1 becomes a scalar, and mul() treats a vector as a row on
// its left and as a column on its right, as required.
//
// Errors: mul() of a column and a row, for which glslang would compute a scalar, and such a matrix in a
// constant buffer, where each of its columns occupies a register.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void make_row_matrices_vectors(TokenText& text);

}  // namespace penumbra::preparation
