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

// A letter or an underscore, with which every word begins and nothing else.
constexpr bool begins_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// One of those or a digit, of which the rest of a word consists.
constexpr bool continues_word(char c) {
  return begins_word(c) || (c >= '0' && c <= '9');
}

struct Token {
  enum class Kind : unsigned char {
    word,
    number,
    text,
    mark
  };  // text: "..."; mark: one character of punctuation
  Kind kind = Kind::mark;
  int line = 0;
  std::string_view spelling;  // points into the lexed text
  std::string_view file;      // as the #line directive spells it; empty before the first that names one
};

// The views live as long as `preprocessed` does. Never fails: what is no word, number or text is a mark.
std::vector<Token> lex(const std::string& preprocessed);
std::vector<Token> lex(std::string&&) = delete;  // what the views point into would be gone

}  // namespace penumbra::hlsl
