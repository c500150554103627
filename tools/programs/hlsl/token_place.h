// Maps a token of the expanded text to its source location, including the column.
//
// A compiler that reports only lines also identifies the token if it reads the text with one token per line:
// line N of its message is token N. The preprocessor keeps no columns, so a token's column is that of the
// same spelling in the source line, counted from the left; a token from a macro expansion gets the location
// of the macro call.
#pragma once

#include "hlsl/source_text.h"
#include "hlsl/tokens.h"

namespace penumbra::hlsl {

struct TokenPlace {
  std::string file;
  int line = 0;
  int column = 0;  // 1-based; 0 if unknown
};

class TokenPlaces {
 public:
  // `preprocessed` must outlive this object; lines before the first #line directive belong to `main_file`.
  TokenPlaces(const std::string& preprocessed, std::string main_file);

  std::string one_per_line() const;
  std::size_t size() const { return tokens_.size(); }
  const Token& operator[](std::size_t index) const { return tokens_[index]; }

  bool same_line(std::size_t a, std::size_t b) const;
  TokenPlace at(std::size_t index, const SourceFiles& sources) const;
  TokenPlace after(std::size_t index, const SourceFiles& sources) const;  // the column right after it

  // Returns the index of the function's name in its definition, or else in its first declaration; size() if
  // there is none.
  std::size_t function(std::string_view name) const;

 private:
  std::string file_of(const Token& token) const;
  bool declares(std::size_t index, std::string_view name) const;

  std::vector<Token> tokens_;
  std::string main_file_;
};

// Returns the 1-based column of the rank-th (from 0) of `count` tokens with that spelling; 0 if the line has
// another number of them.
int column_in(std::string_view source_line, std::string_view spelling, std::size_t rank, std::size_t count);

// Returns whether no identifier goes on beyond these characters.
bool is_whole_word(std::string_view text, std::size_t at, std::size_t length);

// Returns the 1-based column of the word if it occurs exactly once, and as a whole word, else 0.
int column_of_word(std::string_view word, std::string_view line);

// Returns the 1-based column just after the last character that is neither blank nor comment.
int column_after_code(std::string_view source_line);

}  // namespace penumbra::hlsl
