// A record of glslang's matrix products that are operators. Its syntax tree has one kind of node for mul(m,
// n), the product of linear algebra, and for m * n, which HLSL does element by element; their source
// locations differ. Internal to this folder.
#pragma once

#include <glslang/Include/intermediate.h>

#include <set>
#include <string>
#include <tuple>

namespace penumbra::shaders {

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

}  // namespace penumbra::shaders
