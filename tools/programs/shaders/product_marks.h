// Which of glslang's products of matrices are operators. Its tree has one kind of node for mul(m, n), the
// product of linear algebra, and for m * n, which HLSL does element by element; the places of the two differ.
// Internal to this room.
#pragma once

#include <glslang/Include/intermediate.h>

#include <set>
#include <string>
#include <tuple>

namespace penumbra::shaders {

class ProductMarks {
 public:
  // `text` is what glslang has parsed; `main_file` names what stands before its first #line.
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

}  // namespace penumbra::shaders
