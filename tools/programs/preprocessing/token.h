// A preprocessing token and its location. Internal to this folder.
#pragma once

#include <stdexcept>

#include "preprocessing/spellings.h"

namespace penumbra::preprocessing {

enum class Kind : std::uint8_t {
  end,  // the end of the text
  newline,
  argument_end,
  identifier,
  integer,  // a number of type int, which #if can evaluate
  number,   // any other number
  string,
  punctuation,
  paste,   // ## in a macro's body
  unusual  // anything that only glslang's preprocessor reads
};

constexpr std::int16_t no_parameter = -1;

struct Token {
  Kind kind = Kind::end;
  bool space = false;                     // white space or a comment precedes it
  std::int16_t parameter = no_parameter;  // in a macro's body: the index of the parameter that it names
  Spelling spelling = 0;

  bool is(Spelling punctuation) const { return kind == Kind::punctuation && spelling == punctuation; }
};

// Lines and columns count from 1. `after` is the column that glslang's scanner reports once it has read the
// token; 0 if unknown. `joined` means that a backslash right after the token joins the next line, and
// glslang's scanner, which has read that line's first character, reports a location on that line.
struct Place {
  int line = 0;
  int column = 0;
  int after = 0;
  bool joined = false;
};

// Thrown inside this folder: glslang's preprocessor has to read the source.
class Unusual : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The spaces that glslang's preprocessor prints between two tokens (DoPreprocessing in its ShaderLang.cpp).
constexpr bool is_tight(Kind kind, Spelling spelling) {
  return kind == Kind::punctuation &&
         (spelling == known::semicolon || spelling == known::open || spelling == known::close ||
          spelling == known::open_square || spelling == known::close_square);
}

constexpr bool blank_between(const Token& before, const Token& after) {
  return before.kind != Kind::end && !is_tight(before.kind, before.spelling) &&
         !is_tight(after.kind, after.spelling) && !after.is(known::comma);
}

}  // namespace penumbra::preprocessing
