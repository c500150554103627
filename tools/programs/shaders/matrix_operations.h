// Operators and intrinsic functions of HLSL that work on matrices element by element: abs(m), lerp(m, n, t),
// m / s, any(m). glslang's tree has one node for each, of which its SPIR-V back end makes instructions that
// do not take matrices, or ends the process. They are written out row by row in the tree, where every type is
// known:
//
//   lerp(m, n, t)  ->  (a = m, b = n, float2x2(lerp(a[0], b[0], t), lerp(a[1], b[1], t)))
//
// What the front end has already given another meaning cannot be put right there and is an error. Internal to
// this room.
#pragma once

#include <glslang/Include/intermediate.h>

#include <vector>

#include "shaders/product_marks.h"
#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {

// What it cannot write out, in order.
std::vector<ModuleProblem> write_out_matrix_operations(glslang::TIntermediate& tree, ProductMarks marks);

}  // namespace penumbra::shaders
