#include "preparation/intrinsic_calls.h"

#include <string>
#include <string_view>
#include <vector>

#include "preparation/list_elements.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

void as_uint(TokenText& text, const ListElement& argument) {
  const bool literal =
      argument.end - argument.first == 1 && text[argument.first].kind == hlsl::Token::Kind::number;
  if (!literal) return;
  text.insert(argument.first, "uint(");
  text.insert(argument.end, ")");
}

// The calls are buffer.InterlockedAdd(address, value[, original]); ...CompareExchange(address, compare,
// value, original).
void give_uint_values(TokenText& text, std::string_view name, const std::vector<ListElement>& given) {
  const std::size_t values = name.find("Compare") == std::string_view::npos ? 1 : 2;
  for (std::size_t i = 1; i <= values && i < given.size(); ++i) as_uint(text, given[i]);
}

// Returns the statement's first token, for `InterlockedCompareStore(...);` and
// `buffer.InterlockedCompareStore(...);`; npos where it is part of something else.
std::size_t statement_of(const TokenText& text, std::size_t name, std::size_t close) {
  if (!text.is(close + 1, ";")) return npos;
  std::size_t first = name;
  if (text.is(name - 1, ".")) first = name < 2 ? npos : text.types().begin(name - 2);
  if (first == npos || first == 0) return npos;
  for (const char* before : {";", "{", "}", ")", "else", ":"})
    if (text.is(first - 1, before)) return first;
  return npos;
}

void exchange(TokenText& text, std::size_t name, const std::string& variable) {
  const std::size_t close = text.matching_bracket(name + 1);
  const std::size_t first = statement_of(text, name, close);
  if (first == npos) return;
  const std::vector<ListElement> given = list_elements(text, name + 1);
  if (given.size() != 3) return;
  const ValueType& changed = text.types().at(given[0].end - 1);
  const bool is_int = !text.is(name - 1, ".") && (changed.name == "int" || changed.element == "int");
  for (std::size_t i = 1; i < 3 && !is_int && !text.is(name - 1, "."); ++i) as_uint(text, given[i]);
  text.insert(first, "{ " + std::string(is_int ? "int " : "uint ") + variable + "; ");
  text.replace(name, 1, "InterlockedCompareExchange");
  text.insert(close, ", " + variable);
  text.insert(close + 2, " }");
}

}  // namespace

void write_out_intrinsic_calls(TokenText& text) {
  const std::string variable = text.free_name("penumbra_old_value");
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    if (!text.is_identifier(at) || !text.is(at + 1, "(") || text.matching_bracket(at + 1) == npos) continue;
    const std::string_view name = text[at].spelling;
    if (text.is(at - 1, ".") && name.substr(0, 11) == "Interlocked")
      give_uint_values(text, name, list_elements(text, at + 1));
    if (name == "InterlockedCompareStore") exchange(text, at, variable);
  }
  text.apply();
}

}  // namespace penumbra::preparation
