#include "preparation/passes.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// Returns "float" for float4x4; empty for other identifiers and for integer matrices.
std::string_view scalar_of_matrix(std::string_view word) {
  if (word.size() < 7 || word[word.size() - 2] != 'x') return {};  // nearly all identifiers
  for (const std::string_view scalar :
       {std::string_view("float"), std::string_view("half"), std::string_view("double"),
        std::string_view("min16float"), std::string_view("min10float")}) {
    if (word.substr(0, scalar.size()) != scalar || word.size() != scalar.size() + 3) continue;
    const std::string_view shape = word.substr(scalar.size());
    const auto size = [](char c) { return c >= '1' && c <= '4'; };
    if (size(shape[0]) && shape[1] == 'x' && size(shape[2])) return scalar;
  }
  return {};
}

bool is_whole_number(std::string_view number) {
  const bool hexadecimal = number.size() > 1 && (number[1] == 'x' || number[1] == 'X');
  return hexadecimal || number.find_first_not_of("0123456789uUlL") == std::string_view::npos;
}

bool is_whole_scalar(std::string_view type) {
  return type == "int" || type == "uint" || type == "bool" || type == "dword";
}

// Returns the token after the integer literal with its sign, or the name of an integer, that begins here;
// npos for anything else.
std::size_t end_of_scalar(const TokenText& text, std::size_t at) {
  while (text.is_any(at, "-", "+")) ++at;
  if (at >= text.size()) return npos;
  const hlsl::Token& token = text[at];
  if (token.kind == hlsl::Token::Kind::number) return is_whole_number(token.spelling) ? at + 1 : npos;
  if (token.spelling == "true" || token.spelling == "false") return at + 1;
  if (token.kind != hlsl::Token::Kind::identifier || text.is_any(at + 1, "(", ".", "[")) return npos;
  const ValueType& type = text.types().at(at);
  return is_whole_scalar(type.name) && type.dimensions == 0 ? at + 1 : npos;
}

}  // namespace

// An integer or bool cast to a float matrix, `(float4x4)0` and `float3x3(1)`. glslang 12 folds the conversion
// and silently leaves every element but the first few uninitialised: their values differ between runs. The
// number is cast to float first, `(float4x4)(float)0`, which is folded correctly.
//
// Applies to literals with their sign, true and false, and names of scalars; glslang converts run-time values
// correctly.
void widen_matrix_casts(TokenText& text) {
  for (std::size_t at = 1; at + 2 < text.size(); ++at) {
    const std::string_view scalar =
        text.is_identifier(at) ? scalar_of_matrix(text.word(at)) : std::string_view{};
    if (scalar.empty()) continue;
    const bool cast = text.is(at - 1, "(") && text.is(at + 1, ")");
    const bool constructor = text.is(at + 1, "(");
    const std::size_t end = cast || constructor ? end_of_scalar(text, at + 2) : npos;
    if (end == npos || (constructor && !text.is(end, ")"))) continue;
    text.insert(at + 2, "(" + std::string(scalar) + ")");
  }
  text.apply();
}

}  // namespace penumbra::preparation
