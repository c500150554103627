#include <cctype>
#include <utility>

#include "hlsl/declarations.h"
#include "hlsl/name_set.h"
#include "preparation/declarators.h"
#include "preparation/declared_values.h"
#include "preparation/passes.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

constexpr hlsl::NameSet typed("Texture2D", "Texture2DArray", "Texture3D", "TextureCube", "TextureCubeArray",
                              "Texture2DMS", "sampler2D", "sampler3D", "samplerCUBE", "sampler",
                              "SamplerState", "sampler1D");

// Returns the type without its precision; empty if the identifier is not such a type.
std::string_view plain_type(std::string_view word) {
  for (const std::string_view suffix : {std::string_view("_half"), std::string_view("_float")}) {
    if (word.size() <= suffix.size() || word.substr(word.size() - suffix.size()) != suffix) continue;
    const std::string_view stem = word.substr(0, word.size() - suffix.size());
    if (typed.contains(stem)) return stem;
  }
  return {};
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> known_scalars{{{"min16float", "half"},
                                                                                      {"min10float", "half"},
                                                                                      {"min16int", "int"},
                                                                                      {"min12int", "int"},
                                                                                      {"min16uint", "uint"}}};

bool is_matrix_shape(std::string_view shape) {
  const auto size = [](char c) { return c >= '1' && c <= '4'; };
  return shape.size() == 3 && size(shape[0]) && shape[1] == 'x' && size(shape[2]);
}

// Returns the equivalent matrix type of glslang; empty if the identifier is not a matrix of minimum
// precision.
std::string known_matrix(std::string_view word) {
  for (const auto& [minimum, known] : known_scalars) {
    if (word.substr(0, minimum.size()) != minimum || !is_matrix_shape(word.substr(minimum.size()))) continue;
    return std::string(known) + std::string(word.substr(minimum.size()));
  }
  return {};
}

// Returns the letter of b0, t12, s[3], u1, c4; '\0' for identifiers that are not a register.
char register_kind(const TokenText& text, std::size_t at) {
  const std::string_view word = at < text.size() ? text.word(at) : std::string_view{};
  const bool bracket = word.size() == 1 && text.is(at + 1, "[");
  const bool numbered = word.size() > 1 && word.find_first_not_of("0123456789", 1) == std::string_view::npos;
  return text.is_identifier(at) && (bracket || numbered) ? static_cast<char>(std::tolower(word[0])) : '\0';
}

// Simplifies or removes the `: register(...)` whose `register` is at this token.
void plain(TokenText& text, std::size_t at) {
  const std::size_t close = text.matching_bracket(at + 1);
  if (close == npos || at == 0 || !text.is(at - 1, ":")) return;
  std::size_t named = at + 2;
  const bool profile = text.is(named + 1, ",") && register_kind(text, named) == '\0';
  if (profile) named += 2;
  const char kind = register_kind(text, named);
  const bool replaced = text.is(close + 1, ":") && text.is(close + 2, "register");
  if (replaced || kind == 'c' || kind == 'i') {
    text.erase(at - 1, close - at + 2);
    return;
  }
  if (profile) text.erase(at + 2, 2);
  if (kind != '\0' && text.is(named + 1, "[") && text.matching_bracket(named + 1) == named + 3)
    text.replace(named, 4, text.name(named) + text.name(named + 2));
}

// A statement or another attribute of it follows the ']' of an attribute.
bool is_before_statement(const TokenText& text, std::size_t at) {
  static constexpr hlsl::NameSet statements("for", "while", "do", "if", "switch");
  at = text.after_subscripts(at);
  return text.is_identifier(at) && statements.contains(text.word(at));
}

// Drops a ';' between the braces of a struct or cbuffer: at the beginning, after another, or after a member
// function's body.
void drop_among_members(TokenText& text, const hlsl::Declaration& declaration) {
  for (std::size_t at = declaration.open + 1; at < declaration.close; ++at) {
    const bool stray = text.is(at, ";") && text.is_any(at - 1, ";", "{", "}");
    if (stray) text.erase(at, 1);
    const bool body = text.is(at, "{") && text.matching_bracket(at) != npos;
    if (body) at = text.matching_bracket(at);
  }
}

}  // namespace

// `const static uint N = 4;`: the order of the two keywords has no meaning in HLSL
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-variable-syntax), but glslang only regards
// the later one, and a variable that is not constant cannot be an array's size. `static` is moved to the
// front.
void put_static_first(TokenText& text) {
  for (std::size_t at = 1; at < text.size(); ++at) {
    if (!text.is(at, "static")) continue;
    for (std::size_t before = at;
         before-- > 0 && text.is_identifier(before) && is_modifier(text.word(before));) {
      if (!text.is(before, "const")) continue;
      text.erase(before, 1);
      text.replace(at, 1, "static const");
      break;
    }
  }
  text.apply();
}

// `float F(float a, uniform float b)`: in functions that the entry point calls, `uniform` has no effect in
// HLSL. glslang does not convert the arguments of such parameters: `F(x, 2)` becomes SPIR-V that does not
// validate.
void drop_uniform_of_parameters(TokenText& text) {
  const ValueTypes& types = text.types();
  for (const FunctionType& function : types.functions()) {
    if (function.name == npos || text.is(function.name, text.entry())) continue;
    for (const std::size_t parameter : function.parameters) {
      const DeclaredValue& value = types.declared()[parameter];
      if (value.first == npos || value.type_at == npos) continue;
      for (std::size_t at = value.first; at < value.type_at; ++at)
        if (text.is(at, "uniform")) text.erase(at, 1);
    }
  }
  text.apply();
}

// Texture and sampler types with a precision suffix, Texture2D_half, sampler2D_float and similar (Unity's,
// docs.unity3d.com/Manual/SL-DataTypesAndPrecision.html), become the plain type. half is float here, so only
// the name changes.
void drop_texture_precision(TokenText& text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char lead = text.lead(at);
    if (lead != 'T' && lead != 's' && lead != 'S') continue;  // all of them begin with one of these
    const std::string_view plain = plain_type(text.word(at));
    if (!plain.empty()) text.replace(at, 1, plain);
  }
  text.apply();
}

// Matrices of minimum precision, `min16float3x3`, which glslang's front end does not know although it knows
// the scalars and vectors: `half3x3` expands to one on mobile targets. They become `half3x3`, and matrices of
// min16int, min12int and min16uint those of int and uint.
//
// Minimum precision permits more bits (docs.microsoft.com/windows/win32/direct3dhlsl/
// using-hlsl-minimum-precision), and half is float here, so the requested precision is met.
void name_precision_matrices(TokenText& text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text.lead(at) != 'm') continue;  // all of them begin with it
    const std::string known = known_matrix(text.word(at));
    if (!known.empty()) text.replace(at, 1, known);
  }
  text.apply();
}

// register() annotations that have no effect here, or a syntax that glslang does not parse. Bindings are
// renumbered in the module and constants are found by reflection, so a register only determines the kind of a
// resource, which follows from its type, and its space, which is kept.
//
// - `register(ps_5_0, t0)` loses the profile, `register(s[2])` its brackets; of several the last is kept.
// - `register(c3)`, `register(c1.y)`, `register(i0)` on anything but a resource are removed: they place a
//   constant in Direct3D 9's registers, for which glslang overlaps members or reports the '.'.
//
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-variable-register)
void plain_registers(TokenText& text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at)
    if (text.is(at, "register") && text.is(at + 1, "(")) plain(text, at);
  text.apply();
}

// Attributes of statements that control FXC's code generation and do not change results: [fastopt],
// [allow_uav_condition], [forcecase], [call], and [maxtessfactor()] of a hull program, a hint for the
// tessellator. glslang warns that they "do not apply"; they are removed.
void drop_statement_attributes(TokenText& text) {
  static constexpr hlsl::NameSet attributes("fastopt", "allow_uav_condition", "forcecase", "call");
  for (std::size_t at = 0; at + 3 < text.size(); ++at) {
    if (!text.is(at, "[") || !text.is_identifier(at + 1)) continue;
    const bool statement =
        text.is(at + 2, "]") && attributes.contains(text.word(at + 1)) && is_before_statement(text, at + 3);
    const bool factor = text.is(at + 1, "maxtessfactor") && text.is(at + 2, "(");
    if (statement || (factor && text.matching_bracket(at) != npos))
      text.erase(at, text.matching_bracket(at) + 1 - at);
  }
  text.apply();
}

// Empty declarations: a ';' at file scope, often left by a macro that expands to nothing, and after another
// ';' among the members of a struct or cbuffer. Unity's compilers accept them; glslang's grammar does not
// ("Expected declaration"). They are removed.
void drop_stray_semicolons(TokenText& text) {
  using Kind = hlsl::Declaration::Kind;
  for (const hlsl::Declaration& declaration : text.declarations()) {
    if (declaration.kind == Kind::empty)
      text.erase(declaration.first, declaration.last - declaration.first + 1);
    if (declaration.kind == Kind::structure || declaration.kind == Kind::buffer)
      drop_among_members(text, declaration);
  }
  text.apply();
}

}  // namespace penumbra::preparation
