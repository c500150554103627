// Inputs and outputs with types that HLSL allows and Vulkan, OpenGL and Metal do not (GLSL 4.50, 4.3.4; VUID
// StandaloneSpirv-Input-07290).
//
// - `bool lit : TEXCOORD1`, `bool2`, ...: passed as uint, as in Direct3D's interface; reads convert to bool,
//   writes to 0 and 1.
// - `uint front : SV_IsFrontFace`: becomes bool, which is 0 or 1 when used as a number. A warning says that
//   true is 0xFFFFFFFF in Direct3D.

#include "preparation/passes.h"

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
    NumberShape shape = shape_of_type(text.word(type));
    if (!shape.known() || shape.is_matrix()) continue;
    const std::string semantic = semantic_key(text.word(colon + 1));
    const bool is_face = semantic == "SV_ISFRONTFACE";
    if (shape.base == Base::boolean && !semantic.starts_with("SV_")) {
      text.replace(type, 1, type_of_shape(shape.of_base(Base::natural)));
    } else if (is_face && shape.is_scalar() && (shape.base == Base::natural || shape.base == Base::integer)) {
      text.replace(type, 1, "bool");
      text.warn(
          colon + 1,
          "'" + text.name(colon + 1) +
              "' read as a number is 0xFFFFFFFF on Direct3D and 1 elsewhere: compare it with 0, or declare "
              "a bool");
    }
  }
  text.apply();
}

}  // namespace penumbra::preparation
