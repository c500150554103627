// A preprocessing token and its location. Internal to this folder.
#pragma once

#include <stdexcept>
#include <string>

#include "preprocessing/spellings.h"

namespace penumbra::preprocessing {

enum class Kind : std::uint8_t {
  end,  // the end of the text, or of the tokens that are read
  newline,
  identifier,
  integer,  // an integer, which #if can evaluate
  number,   // any other number
  string,
  punctuation,
  paste,  // ## in a macro's body
  bad     // a character or byte that begins no token, or a text without its closing '"'
};

constexpr std::int16_t no_parameter = -1;

struct Token {
  Kind kind = Kind::end;
  bool space = false;                     // white space or a comment precedes it
  bool final = false;                     // a name in its own macro's expansion, which is not expanded again
  std::int16_t parameter = no_parameter;  // in a macro's body: the index of the parameter that it names
  Spelling spelling = 0;

  bool is(Spelling punctuation) const { return kind == Kind::punctuation && spelling == punctuation; }
};

// Lines and columns count from 1.
struct Place {
  int line = 0;
  int column = 0;
};

// An error of the source, thrown inside this folder. A place with line 0 is filled in by the reader.
class Problem : public std::runtime_error {
 public:
  explicit Problem(const std::string& message, Place at = {}) : runtime_error(message), place(at) {}

  Place place;
};

// Returns what is wrong with a token of kind `bad`.
std::string message_for_bad(std::string_view spelling);

// A space is printed between two tokens unless one of them is a bracket, a ';' or a comma that follows.
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
