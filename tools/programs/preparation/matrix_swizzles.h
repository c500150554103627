// Matrix swizzles of two to four elements, `m._m03_m13_m23` and `m._11_22` (HLSL: docs "Matrix Ordering and
// swizzling"). glslang's SPIR-V back end has none: it crashes, prints "Missing functionality" and goes on, or
// writes what SPIR-V validation refuses.
//
// - Read: the swizzled expression becomes the argument of a function of ours, defined once at the top for
// every
//   shape of matrix that has the elements; so it is evaluated once, calls included.
// - Assigned to, simply or compound, as a statement of its own: a block that evaluates the right side first
// and
//   then assigns element by element. The matrix expression is repeated, so it must not hold a call, ++ or --:
//   those are left as they are, which glslang refuses with a message.
// Single elements (`m._m00`) work and stay. When a struct of the text has a member of the same name, all
// swizzles of that name stay.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_matrix_swizzles(TokenText& text);

}  // namespace penumbra::preparation
