// The lexer: tokens of preprocessed HLSL, each with its source location. Internal to this folder.
//
// The text is preprocessor output: no comments, no macros; #line directives give the origin of lines, and
// every other line that starts with '#' is skipped.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::hlsl {

// Returns whether an identifier may begin with this character.
constexpr bool begins_identifier(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// Returns whether an identifier may contain this character after the first.
constexpr bool continues_identifier(char c) {
  return begins_identifier(c) || (c >= '0' && c <= '9');
}

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

}  // namespace penumbra::hlsl
