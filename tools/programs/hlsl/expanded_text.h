// Preprocessed text, line by line with its origin.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra::hlsl {

struct CodeLine {
  std::string file;
  int line = 0;
  std::string text;
};

// Splits preprocessor output at its #line directives; lines before the first belong to `main_file`.
std::vector<CodeLine> expanded_lines(const std::string& preprocessed, const std::string& main_file);

// Up to this many empty lines are shorter than a #line directive.
inline constexpr int most_empty_lines = 16;

// Returns preprocessed text without its empty lines, with a #line directive only where one is needed: the
// same code at the same locations gives the same text, whatever was removed between. Each token keeps its
// file, line and column.
std::string dense_lines(std::string_view preprocessed);

}  // namespace penumbra::hlsl
