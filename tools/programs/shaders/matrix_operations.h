// Operators and intrinsic functions of HLSL that work on matrices element by element: abs(m), lerp(m, n, t),
// m / s, any(m). glslang's syntax tree has one node for each, for which its SPIR-V back end emits
// instructions that do not accept matrices, or crashes. They are expanded row by row in the tree, where every
// type is known:
//
//   lerp(m, n, t)  ->  (a = m, b = n, float2x2(lerp(a[0], b[0], t), lerp(a[1], b[1], t)))
//
// Operations whose meaning the front end has already changed cannot be corrected there and are errors.
// Internal to this folder.
#pragma once

#include <glslang/Include/intermediate.h>

#include <vector>

#include "shaders/product_marks.h"
#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {

// Returns the operations that it cannot expand, in order.
std::vector<hlsl::Diagnostic> write_out_matrix_operations(glslang::TIntermediate& tree, ProductMarks marks);

}  // namespace penumbra::shaders
