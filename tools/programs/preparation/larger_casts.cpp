#include <string>

#include "preparation/number_shape.h"
#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// Returns the last token of the chain that begins here: a name with its members, elements and arguments.
std::size_t chain_end(const TokenText& text, std::size_t at) {
  for (;;) {
    const bool bracket = text.is(at + 1, "[") || text.is(at + 1, "(");
    if (bracket && text.matching_bracket(at + 1) != npos)
      at = text.matching_bracket(at + 1);
    else if (text.is(at + 1, ".") && text.is_identifier(at + 2))
      at += 2;
    else
      return at;
  }
}

// A scalar is spread over any shape.
bool is_larger(const NumberShape& wanted, const NumberShape& given) {
  if (!wanted.known() || !given.known() || given.is_scalar()) return false;
  if (wanted.is_matrix() != given.is_matrix()) return false;  // float2x2 and float4 hold as much
  return wanted.rows > given.rows || wanted.columns > given.columns;
}

}  // namespace

void check_larger_casts(TokenText& text) {
  const ValueTypes& types = text.types();
  for (std::size_t at = 1; at + 2 < text.size(); ++at) {
    if (!text.is_identifier(at) || !text.is(at - 1, "(") || !text.is(at + 1, ")")) continue;
    if (at > 1 && text.is_identifier(at - 2) && !text.is(at - 2, "return")) continue;  // f(float4)
    const NumberShape wanted = shape_of_type(text[at].spelling);
    if (!wanted.known() || !text.is_identifier(at + 2)) continue;
    const std::size_t last = chain_end(text, at + 2);
    if (types.begin(last) != at + 2 || types.at(last).dimensions > 0) continue;
    if (!is_larger(wanted, shape_of_type(types.at(last).name))) continue;
    text.note(at, hlsl::Severity::error,
              "cannot convert from '" + std::string(types.at(last).name) + "' to '" +
                  std::string(text[at].spelling) +
                  "', which is larger (X3017): write a constructor with all numbers");
  }
}

}  // namespace penumbra::preparation
