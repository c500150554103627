#include "preparation/statement_attributes.h"

#include "hlsl/name_set.h"

namespace penumbra::preparation {

namespace {

// A statement or another attribute of it follows the ']' of an attribute.
bool is_before_statement(const TokenText& text, std::size_t at) {
  static constexpr hlsl::NameSet statements("for", "while", "do", "if", "switch");
  while (text.is(at, "[") && text.matching_bracket(at) != npos) at = text.matching_bracket(at) + 1;
  return text.is_identifier(at) && statements.contains(text[at].spelling);
}

}  // namespace

void drop_statement_attributes(TokenText& text) {
  static constexpr hlsl::NameSet attributes("fastopt", "allow_uav_condition", "forcecase", "call");
  for (std::size_t at = 0; at + 3 < text.size(); ++at) {
    if (!text.is(at, "[") || !text.is_identifier(at + 1)) continue;
    const bool statement = text.is(at + 2, "]") && attributes.contains(text[at + 1].spelling) &&
                           is_before_statement(text, at + 3);
    const bool factor = text.is(at + 1, "maxtessfactor") && text.is(at + 2, "(");
    if (statement || (factor && text.matching_bracket(at) != npos))
      text.erase(at, text.matching_bracket(at) + 1 - at);
  }
  text.apply();
}

}  // namespace penumbra::preparation
