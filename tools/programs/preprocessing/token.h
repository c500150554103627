// A token of the preprocessor and where it stands. Internal to this room.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "preprocessing/spellings.h"

namespace penumbra::preprocessing {

enum class Kind : std::uint8_t {
  end,  // of the text
  newline,
  argument_end,
  identifier,
  integer,  // int: what #if can reckon with
  number,   // any other
  string,
  punctuation,
  paste,   // ## in a macro's body
  unusual  // whatever this preprocessor leaves to glslang's
};

constexpr std::int16_t no_parameter = -1;

struct Token {
  Kind kind = Kind::end;
  bool space = false;                     // a blank or a comment stands before it
  std::int16_t parameter = no_parameter;  // of a macro's body: which parameter of the macro it names
  Spelling spelling = 0;

  bool is(Spelling punctuation) const { return kind == Kind::punctuation && spelling == punctuation; }
};

// From 1. `after` is the column that glslang's scanner names once it has read the token; 0 where that is not
// known here. `joined`: a line is joined on right behind the token, and glslang's scanner, which has looked
// at its first character, names a place on that line.
struct Place {
  int line = 0;
  int column = 0;
  int after = 0;
  bool joined = false;
};

// Thrown inside this room: what follows is for glslang's preprocessor to read.
class Unusual : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace penumbra::preprocessing
