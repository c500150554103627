#include "preparation/register_annotations.h"

#include <cctype>
#include <string_view>

namespace penumbra::preparation {

namespace {

// Returns the letter of b0, t12, s[3], u1, c4; '\0' for identifiers that are not a register.
char register_kind(const TokenText& text, std::size_t at) {
  const std::string_view word = at < text.size() ? text[at].spelling : std::string_view{};
  const bool bracket = word.size() == 1 && text.is(at + 1, "[");
  const bool numbered = word.size() > 1 && word.find_first_not_of("0123456789", 1) == std::string_view::npos;
  return text.is_identifier(at) && (bracket || numbered) ? static_cast<char>(std::tolower(word[0])) : '\0';
}

// Simplifies or removes the `: register(...)` whose `register` is at this token.
void plain(TokenText& text, std::size_t at) {
  const std::size_t close = text.matching_bracket(at + 1);
  if (close == npos || at == 0 || !text.is(at - 1, ":")) return;
  std::size_t named = at + 2;
  const bool profile = text.is(named + 1, ",") && register_kind(text, named) == '\0';
  if (profile) named += 2;
  const char kind = register_kind(text, named);
  const bool replaced = text.is(close + 1, ":") && text.is(close + 2, "register");
  if (replaced || kind == 'c' || kind == 'i') {
    text.erase(at - 1, close - at + 2);
    return;
  }
  if (profile) text.erase(at + 2, 2);
  if (kind != '\0' && text.is(named + 1, "[") && text.matching_bracket(named + 1) == named + 3) {
    text.replace(named, 4, std::string(text[named].spelling) + std::string(text[named + 2].spelling));
  }
}

}  // namespace

void plain_registers(TokenText& text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at)
    if (text.is(at, "register") && text.is(at + 1, "(")) plain(text, at);
  text.apply();
}

}  // namespace penumbra::preparation
