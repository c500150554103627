#include <string>
#include <string_view>

#include "preparation/postfix_expression.h"
#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// Returns the number of characters per component: 1 for xyzw and rgba, 3 for _11, 4 for _m00; 0 for other
// identifiers.
std::size_t component_length(std::string_view word) {
  if (word.empty()) return 0;
  if (word[0] != '_') {
    const bool letters = word.find_first_not_of("xyzw") == std::string_view::npos ||
                         word.find_first_not_of("rgba") == std::string_view::npos;
    return letters && word.size() <= 4 ? 1 : 0;
  }
  const std::size_t length = word.size() > 1 && word[1] == 'm' ? 4 : 3;
  if (word.size() % length != 0 || word.size() > 4 * length) return 0;
  return word.find_first_not_of("_m01234") == std::string_view::npos ? length : 0;
}

// Returns the first repeated component; empty if there is none.
std::string_view repeated(std::string_view word) {
  const std::size_t length = component_length(word);
  for (std::size_t at = length; length != 0 && at < word.size(); at += length)
    for (std::size_t before = 0; before < at; before += length)
      if (word.substr(before, length) == word.substr(at, length)) return word.substr(at, length);
  return {};
}

// Returns whether `_m00_11` has zero-based and one-based subscripts in one swizzle.
bool counts_in_two_ways(std::string_view word) {
  bool from_one = false;
  bool from_zero = false;
  while (word.size() >= 3 && word[0] == '_') {
    const std::size_t length = word[1] == 'm' ? 4 : 3;
    if (word.size() < length ||
        word.substr(length - 2, 2).find_first_not_of("01234") != std::string_view::npos)
      return false;
    (length == 4 ? from_zero : from_one) = true;
    word.remove_prefix(length);
  }
  return word.empty() && from_one && from_zero;
}

bool is_step(const TokenText& text, std::size_t at) {
  return (text.is(at, "+") || text.is(at, "-")) && text.is(at + 1, text[at].spelling) &&
         text[at].spelling.data() + 1 == text[at + 1].spelling.data();
}

bool is_written(const TokenText& text, std::size_t member) {
  std::size_t behind = member + 1;
  while (text.is(behind, ")")) ++behind;
  if (assignment_length(text, behind) != 0 || is_step(text, member + 1)) return true;
  const std::size_t first = postfix_begin(text, member);
  return first != npos && first > 1 && is_step(text, first - 2) && !text.is(member + 1, ".");
}

}  // namespace

void check_repeated_components(TokenText& text) {
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    if (!text.is_identifier(at) || !text.is(at - 1, ".")) continue;
    if (counts_in_two_ways(text[at].spelling) && text.types().named(at) == npos)
      text.note(at, hlsl::Severity::error,
                "'." + std::string(text[at].spelling) +
                    "' mixes zero-based and one-based subscripts: write _m00 or _11 throughout");
    const std::string_view component = repeated(text[at].spelling);
    if (component.empty() || text.types().named(at) != npos || !is_written(text, at)) continue;
    text.note(at, hlsl::Severity::error,
              "'." + std::string(text[at].spelling) + "' has " + std::string(component) +
                  " twice, and cannot be written: name each component once");
  }
}

}  // namespace penumbra::preparation
