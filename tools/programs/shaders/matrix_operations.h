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

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <glslang/Include/intermediate.h>

#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {

// A record of glslang's matrix products that are operators. Its syntax tree has one kind of node for mul(m,
// n), the product of linear algebra, and for m * n, which HLSL does element by element; their source
// locations differ.
class ProductMarks {
 public:
  // `text` is the text that glslang has parsed; lines before its first #line are in `main_file`.
  ProductMarks(const std::string& text, std::string main_file)
      : text_(text), main_file_(std::move(main_file)) {}

  bool stands_at(const glslang::TSourceLoc& place);

 private:
  void read();

  const std::string& text_;
  std::string main_file_;
  bool read_ = false;
  std::set<std::tuple<std::string, int, int>> marks_;  // file, line, column
};

// Returns the operations that it cannot expand, in order.
std::vector<hlsl::Diagnostic> write_out_matrix_operations(glslang::TIntermediate& tree, ProductMarks marks);

}  // namespace penumbra::shaders
