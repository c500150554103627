// Words, numbers and marks of preprocessed HLSL, each with its place in the files it came from. Internal to
// this room.
//
// The text is what a preprocessor leaves: no comments, no macros; #line directives say where lines come from
// and every other line that starts with '#' is skipped.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::hlsl {

struct Token {
  enum class Kind { word, number, text, mark };  // text: "..."; mark: one character of punctuation
  Kind kind = Kind::mark;
  std::string_view spelling;  // points into the lexed text
  std::size_t offset = 0;     // where it does
  std::string_view file;      // as the #line directive spells it; empty before the first that names one
  int line = 0;
};

// The views live as long as `preprocessed` does. Never fails: what is no word, number or text is a mark.
std::vector<Token> lex(const std::string& preprocessed);

}  // namespace penumbra::hlsl
