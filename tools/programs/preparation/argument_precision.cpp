#include "preparation/argument_precision.h"

#include <string_view>

#include "preparation/declarators.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// Returns the numeric type of the cast, variable, member, element or function result that ends at a token.
std::string_view type_ending_at(const TokenText& text, std::size_t at) {
  const std::string_view word = text[at].spelling;
  if (text.is_identifier(at) && is_number_type(word)) return word;
  const std::string_view type = text.is(at + 1, "[") || text.is(at + 1, "(") ? "" : text.types().at(at).name;
  return is_number_type(type) ? type : std::string_view();
}

}  // namespace

bool is_narrow_type(std::string_view type) {
  return type.substr(0, 4) == "half" || type.substr(0, 3) == "min";
}

std::vector<Precision> argument_precisions(const TokenText& text, std::size_t open) {
  const std::size_t close = text.matching_bracket(open);
  std::vector<Precision> all;
  bool narrow = false;
  bool full = false;
  const auto end_argument = [&] {
    all.push_back(narrow && !full ? Precision::narrow : Precision::full);
    narrow = full = false;
  };
  const auto look = [&](std::size_t at) {
    const std::string_view type = type_ending_at(text, at);
    narrow = narrow || (!type.empty() && is_narrow_type(type));
    full = full || (!type.empty() && !is_narrow_type(type));
  };
  for (std::size_t at = open + 1; at < close; ++at) {
    const std::size_t match = text.matching_bracket(at);
    const bool opens = match != npos && match > at;
    if (text.is(at, ",")) {
      end_argument();
    } else if (opens && match == at + 2 && text.is_identifier(at + 1) &&
               is_number_type(text[at + 1].spelling)) {
      look(at + 1);  // a cast, whose operand does not matter
      const std::size_t operand = match + 1;
      const bool group = text.is(operand, "(") && text.matching_bracket(operand) != npos;
      at = postfix_end(text, group ? text.matching_bracket(operand) : operand) - 1;
    } else if (opens && (text.is(at, "[") || !text.types().at(match).name.empty())) {
      look(match);  // a subscript, or the arguments of a known function, do not matter
      at = match;
    } else if (opens) {
      for (; at < match; ++at) look(at);  // its commas do not separate the call's arguments
    } else {
      look(at);
    }
  }
  if (close > open + 1) end_argument();
  return all;
}

}  // namespace penumbra::preparation
