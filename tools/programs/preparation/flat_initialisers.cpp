#include "preparation/flat_initialisers.h"

#include <charconv>
#include <string_view>
#include <vector>

#include "preparation/declarators.h"
#include "preparation/value_shape.h"

namespace penumbra::preparation {

namespace {

// Returns the sizes [2][3]; empty if one is not a literal. `at` is the first '[' and advances past the last
// ']'.
std::vector<std::size_t> sizes(const TokenText& text, std::size_t& at) {
  std::vector<std::size_t> list;
  for (; text.is(at, "["); at += 3) {
    std::size_t size = 0;
    if (at + 2 >= text.size() || !text.is(at + 2, "]")) return {};
    const std::string_view number = text[at + 1].spelling;
    if (std::from_chars(number.data(), number.data() + number.size(), size).ec != std::errc() || size == 0)
      return {};
    list.push_back(size);
  }
  return list;
}

// Returns the first token of each element of the list between the braces; empty when one is itself a list.
std::vector<std::size_t> elements(const TokenText& text, std::size_t open) {
  std::vector<std::size_t> firsts;
  bool at_start = true;
  for (std::size_t at = open + 1; at < text.matching_bracket(open); ++at) {
    if (at_start && text.is(at, "{")) return {};
    if (at_start) firsts.push_back(at);
    at_start = text.is(at, ",");
    if (text.matching_bracket(at) != npos && text.matching_bracket(at) > at) at = text.matching_bracket(at);
  }
  return firsts;
}

void group(TokenText& text, std::size_t open, const std::vector<std::size_t>& firsts, std::size_t run) {
  for (std::size_t i = 0; i < firsts.size(); i += run) {
    text.insert(firsts[i], "{");
    const bool last = i + run >= firsts.size();
    std::size_t end = last ? text.matching_bracket(open) : firsts[i + run] - 1;
    if (last && text.is(end - 1, ",")) --end;
    text.insert(end, "}");
  }
}

}  // namespace

void group_flat_initialisers(TokenText& text) {
  for (std::size_t type = 0; type + 2 < text.size(); ++type) {
    if (!text.is(type + 2, "[") || !text.is_identifier(type) || !text.is_identifier(type + 1)) continue;
    if (!is_number_type(text[type].spelling)) continue;
    std::size_t at = type + 2;
    const std::vector<std::size_t> dimensions = sizes(text, at);
    if (dimensions.empty() || !text.is(at, "=") || !text.is(at + 1, "{") ||
        text.matching_bracket(at + 1) == npos)
      continue;
    std::size_t run = components(text[type].spelling);  // numbers of an element of the first dimension
    for (std::size_t i = 1; i < dimensions.size(); ++i) run *= dimensions[i];
    const std::vector<std::size_t> firsts = elements(text, at + 1);
    const bool deeper =
        dimensions.size() > 2 || (dimensions.size() == 2 && components(text[type].spelling) > 1);
    if (run > 1 && !deeper && firsts.size() == run * dimensions[0]) group(text, at + 1, firsts, run);
  }
  text.apply();
}

}  // namespace penumbra::preparation
