#include "preparation/intrinsic_calls.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "hlsl/outline.h"

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

bool has_function(const TokenText& text, std::string_view name) {
  const auto& all = text.outline();
  return std::any_of(all.begin(), all.end(), [&](const hlsl::Declaration& declaration) {
    return declaration.parameters_open != hlsl::Declaration::none && text.is(declaration.name, name);
  });
}

// mad(a, b, c)  ->  ((a) * (b) + (c))
void write_out_mad(TokenText& text, std::size_t name, const std::vector<Argument>& given) {
  text.replace(name, 2, "((");
  text.replace(given[0].end, 1, ") * (");
  text.replace(given[1].end, 1, ") + (");
  text.replace(given[2].end, 1, "))");
}

// ldexp(x, e)  ->  ((x) * exp2(e))
void write_out_ldexp(TokenText& text, std::size_t name, const std::vector<Argument>& given) {
  text.replace(name, 2, "((");
  text.replace(given[0].end, 1, ") * exp2(");
  text.replace(given[1].end, 1, "))");
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
  const bool own_mad = has_function(text, "mad");
  const bool own_ldexp = has_function(text, "ldexp");
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    if (!text.is_word(at) || !text.is(at + 1, "(") || text.partner(at + 1) == npos) continue;
    const std::string_view name = text[at].spelling;
    const bool method = text.is(at - 1, ".");
    if (method && name.substr(0, 11) == "Interlocked") {
      give_uint_values(text, name, arguments(text, at + 1));
    } else if (!method && name == "mad" && !own_mad) {
      const std::vector<Argument> given = arguments(text, at + 1);
      if (given.size() == 3) write_out_mad(text, at, given);
    } else if (!method && name == "ldexp" && !own_ldexp) {
      const std::vector<Argument> given = arguments(text, at + 1);
      if (given.size() == 2) write_out_ldexp(text, at, given);
    }
  }
  text.apply();
}

}  // namespace penumbra::preparation
