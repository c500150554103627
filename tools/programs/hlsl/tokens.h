// The lexer: tokens of preprocessed HLSL, each with its source location. Internal to this folder.
//
// The text is preprocessor output: no comments, no macros; #line directives give the origin of lines, and
// every other line that starts with '#' is skipped.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "hlsl/identifier.h"

namespace penumbra::hlsl {

struct Token {
  enum class Kind : unsigned char { identifier, number, string, punctuation };  // keywords are identifiers
  Kind kind = Kind::punctuation;  // punctuation is one character
  int line = 0;
  std::string_view spelling;  // points into the lexed text
  std::string_view file;  // the file's spelling in the #line directive; empty before the first that names one
};

// The views are valid as long as `preprocessed`. The lexer never fails: any other character is punctuation.
std::vector<Token> lex(const std::string& preprocessed);
std::vector<Token> lex(std::string&&) = delete;  // the views would dangle

// `#line N "file"`, as a preprocessor emits it.
struct LinePlace {
  std::string_view file;  // the file's spelling in its directive; empty before the first that names one
  int line = 1;
};

// Reads the location of the line after the directive; a directive without a file changes only the line
// number. Returns false for every other line.
inline bool take_line_directive(std::string_view line, LinePlace& next) {
  if (!line.starts_with("#line ")) return false;
  int number = 0;
  if (std::from_chars(line.data() + 6, line.data() + line.size(), number).ec != std::errc()) return false;
  next.line = number;
  const std::size_t open = line.find('"');
  const std::size_t close = line.rfind('"');
  if (open != std::string_view::npos && close > open) next.file = line.substr(open + 1, close - open - 1);
  return true;
}

}  // namespace penumbra::hlsl
