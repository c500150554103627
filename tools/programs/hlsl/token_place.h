// From a token of the expanded text back to where a person wrote it, to the column.
//
// A compiler that reports lines alone tells the token, too, when it reads the text one token a line: line N
// of its message is token N. The preprocessor keeps no columns, so a token's column is that of the same
// spelling in the source line, counted from the left; a token that a macro brought stands where the macro is
// called.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "hlsl/source_text.h"
#include "hlsl/tokens.h"

namespace penumbra::hlsl {

struct TokenPlace {
  std::string file;
  int line = 0;
  int column = 0;  // 1-based; 0 when it cannot be told
};

class TokenPlaces {
 public:
  // `preprocessed` outlives it; `main_file` names what stands before the first #line directive.
  TokenPlaces(const std::string& preprocessed, std::string main_file);

  std::string one_a_line() const;
  std::size_t size() const { return tokens_.size(); }
  const Token& operator[](std::size_t index) const { return tokens_[index]; }

  TokenPlace at(std::size_t index, const SourceFiles& sources) const;
  TokenPlace after(std::size_t index, const SourceFiles& sources) const;  // the column just behind it

  // Where the function is defined (or else declared first): its name's index; size() when nowhere.
  std::size_t function(std::string_view name) const;

 private:
  std::string file_of(const Token& token) const;
  bool same_line(std::size_t a, std::size_t b) const;

  std::vector<Token> tokens_;
  std::string main_file_;
};

// 1-based column of the rank-th (from 0) of `count` tokens of that spelling; 0 when the line has another
// number.
int column_in(std::string_view source_line, std::string_view spelling, std::size_t rank, std::size_t count);

// 1-based column just after the last character that is neither blank nor comment.
int column_after_code(std::string_view source_line);

}  // namespace penumbra::hlsl
