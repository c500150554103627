#include "preparation/interface_types.h"

#include <string>

#include "preparation/number_shape.h"
#include "preparation/semantic_names.h"

namespace penumbra::preparation {

namespace {

// Returns the type of `float2 a[2] : A`, whose ':' stands at `colon`; npos for a later declarator.
std::size_t type_before(const TokenText& text, std::size_t colon) {
  std::size_t name = colon - 1;
  while (text.is(name, "]") && text.matching_bracket(name) != npos && text.matching_bracket(name) > 0)
    name = text.matching_bracket(name) - 1;
  return name > 0 && text.is_identifier(name) && text.is_identifier(name - 1) ? name - 1 : npos;
}

}  // namespace

void pass_bools_as_numbers(TokenText& text) {
  using Base = NumberShape::Base;
  for (std::size_t colon = 2; colon + 1 < text.size(); ++colon) {
    if (!text.is(colon, ":") || !text.is_identifier(colon + 1) || text.is(colon + 2, "(")) continue;
    const std::size_t type = type_before(text, colon);
    if (type == npos) continue;
    NumberShape shape = shape_of_type(text[type].spelling);
    if (!shape.known() || shape.is_matrix()) continue;
    const std::string semantic = semantic_key(text[colon + 1].spelling);
    const bool is_face = semantic == "SV_ISFRONTFACE";
    if (shape.base == Base::boolean && !semantic.starts_with("SV_")) {
      text.replace(type, 1, type_of_shape(shape.of_base(Base::natural)));
    } else if (is_face && shape.is_scalar() && (shape.base == Base::natural || shape.base == Base::integer)) {
      text.replace(type, 1, "bool");
      text.note(
          colon + 1, hlsl::Severity::warning,
          "'" + std::string(text[colon + 1].spelling) +
              "' read as a number is 0xFFFFFFFF on Direct3D and 1 elsewhere: compare it with 0, or declare "
              "a bool");
    }
  }
  text.apply();
}

}  // namespace penumbra::preparation
