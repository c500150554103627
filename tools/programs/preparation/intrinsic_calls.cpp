#include "preparation/intrinsic_calls.h"

#include <string_view>
#include <vector>

#include "preparation/list_elements.h"

namespace penumbra::preparation {

namespace {

void as_uint(TokenText& text, const ListElement& argument) {
  const bool literal =
      argument.end - argument.first == 1 && text[argument.first].kind == hlsl::Token::Kind::number;
  if (!literal) return;
  text.insert(argument.first, "uint(");
  text.insert(argument.end, ")");
}

// buffer.InterlockedAdd(address, value[, original]); ...CompareExchange(address, compare, value, original).
void give_uint_values(TokenText& text, std::string_view name, const std::vector<ListElement>& given) {
  const std::size_t values = name.find("Compare") == std::string_view::npos ? 1 : 2;
  for (std::size_t i = 1; i <= values && i < given.size(); ++i) as_uint(text, given[i]);
}

}  // namespace

void write_out_intrinsic_calls(TokenText& text) {
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    if (!text.is_identifier(at) || !text.is(at + 1, "(") || text.matching_bracket(at + 1) == npos) continue;
    const std::string_view name = text[at].spelling;
    if (text.is(at - 1, ".") && name.substr(0, 11) == "Interlocked")
      give_uint_values(text, name, list_elements(text, at + 1));
  }
  text.apply();
}

}  // namespace penumbra::preparation
