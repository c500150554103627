// Matrix swizzles of two to four elements, `m._m03_m13_m23` and `m._11_22` (HLSL: docs "Matrix Ordering and
// swizzling"). glslang's SPIR-V back end does not support them: it crashes, prints "Missing functionality"
// and continues, or emits invalid SPIR-V.
//
// - Reads: the swizzled expression becomes the argument of a generated function, with an overload for every
//   shape of matrix that has the elements; so it is evaluated once, including calls.
// - Simple or compound assignments that are a statement of their own: a block that evaluates the right side
//   first and then assigns element by element. The matrix expression is repeated, so it must not contain a
//   call, ++ or --: such statements are not changed, and glslang reports an error.
//
// Single elements (`m._m00`) work and are not changed. If a struct of the text has a member of the same name,
// no swizzle of that name is changed.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_matrix_swizzles(TokenText& text);

}  // namespace penumbra::preparation
