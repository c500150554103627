#include "preparation/const_casts.h"

#include "hlsl/name_set.h"

namespace penumbra::preparation {

void drop_const_of_casts(TokenText& text) {
  static constexpr hlsl::NameSet statements("return", "case", "else", "do");
  for (std::size_t at = 1; at + 3 < text.size(); ++at) {
    if (!text.is(at, "(") || !text.is(at + 1, "const") || !text.is_identifier(at + 2) ||
        !text.is(at + 3, ")"))
      continue;
    const bool is_parameter = text.is_identifier(at - 1) && !statements.contains(text[at - 1].spelling);
    if (!is_parameter) text.erase(at + 1, 1);
  }
  text.apply();
}

}  // namespace penumbra::preparation
