// Interned token spellings: equal spellings have equal numbers. Internal to this folder.
#pragma once

#include <deque>
#include <string>

#include "hlsl/string_interner.h"

namespace penumbra::preprocessing {

using Spelling = std::uint32_t;

// The spellings that the preprocessor itself uses, in the order in which Spellings adds them first.
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
  question,
  colon,
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
  word_include_with_pragmas,
  word_pragma,
  word_warning,
  word_line_directive,
  word_error,
  word_line,
  count
};
}  // namespace known

class Spellings {
 public:
  Spellings();

  Spelling number(std::string_view text);
  const std::string& text(Spelling spelling) const { return texts_[spelling]; }

 private:
  std::deque<std::string> texts_;  // elements never move: numbers_ refers to them
  hlsl::StringInterner numbers_;
};

}  // namespace penumbra::preprocessing
