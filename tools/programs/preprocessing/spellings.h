// A number for every spelling of a token, the same for equal spellings. Internal to this room.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

#include "hlsl/word_numbers.h"

namespace penumbra::preprocessing {

using Spelling = std::uint32_t;

// What the preprocessor itself knows, in the order in which Spellings takes it in first.
namespace known {
enum : Spelling {
  open,
  close,
  open_square,
  close_square,
  open_brace,
  close_brace,
  comma,
  semicolon,
  hash,
  logical_or,
  logical_and,
  bit_or,
  bit_xor,
  bit_and,
  equal,
  unequal,
  greater,
  at_least,
  less,
  at_most,
  shift_left,
  shift_right,
  plus,
  minus,
  times,
  divide,
  remainder,
  complement,
  negate,
  word_defined,
  word_define,
  word_undef,
  word_if,
  word_ifdef,
  word_ifndef,
  word_elif,
  word_else,
  word_endif,
  word_include,
  count
};
}  // namespace known

class Spellings {
 public:
  Spellings();

  Spelling number(std::string_view text);
  const std::string& text(Spelling spelling) const { return texts_[spelling]; }

 private:
  std::deque<std::string> texts_;  // never move: the views below are of them
  hlsl::WordNumbers numbers_;
};

}  // namespace penumbra::preprocessing
