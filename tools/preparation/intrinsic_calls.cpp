#include "preparation/intrinsic_calls.h"

#include <string_view>
#include <vector>

namespace penumbra::preparation {

namespace {

// The tokens of one argument: [first, end).
struct Argument {
  std::size_t first;
  std::size_t end;
};

std::vector<Argument> arguments(const TokenText& text, std::size_t open) {
  const std::size_t close = text.partner(open);
  std::vector<Argument> list;
  std::size_t first = open + 1;
  for (std::size_t at = first; at <= close; ++at) {
    if (at == close || text.is(at, ",")) {
      if (at > first) list.push_back({first, at});
      first = at + 1;
    } else if (text.partner(at) != npos && text.partner(at) > at) {
      at = text.partner(at);
    }
  }
  return list;
}

void as_uint(TokenText& text, const Argument& argument) {
  const bool literal =
      argument.end - argument.first == 1 && text[argument.first].kind == hlsl::Token::Kind::number;
  if (!literal) return;
  text.insert(argument.first, "uint(");
  text.insert(argument.end, ")");
}

// buffer.InterlockedAdd(address, value[, original]); ...CompareExchange(address, compare, value, original).
void give_uint_values(TokenText& text, std::string_view name, const std::vector<Argument>& given) {
  const std::size_t values = name.find("Compare") == std::string_view::npos ? 1 : 2;
  for (std::size_t i = 1; i <= values && i < given.size(); ++i) as_uint(text, given[i]);
}

}  // namespace

void write_out_intrinsic_calls(TokenText& text) {
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    if (!text.is_word(at) || !text.is(at + 1, "(") || text.partner(at + 1) == npos) continue;
    const std::string_view name = text[at].spelling;
    if (text.is(at - 1, ".") && name.substr(0, 11) == "Interlocked")
      give_uint_values(text, name, arguments(text, at + 1));
  }
  text.apply();
}

}  // namespace penumbra::preparation
