// The places where a variable is written to: by an assignment, by ++ or --, or as the argument of an out or
// inout parameter of a function of the text. Internal to this folder.
#pragma once

#include <map>
#include <set>

#include "preparation/token_text.h"

namespace penumbra::preparation {

class WrittenValues {
 public:
  explicit WrittenValues(const TokenText& text);  // valid until its apply()

  // Returns whether the value that begins with the name at this token, its elements and members included, is
  // written there.
  bool writes(std::size_t at) const;

 private:
  std::size_t end_of_value(std::size_t at) const;
  bool stepped(std::size_t begin, std::size_t end) const;
  bool passed_out(std::size_t begin, std::size_t end) const;

  const TokenText& text_;
  // The written parameters of each function.
  std::map<std::string_view, std::set<std::size_t>> out_parameters_;
};

}  // namespace penumbra::preparation
