#include <algorithm>

#include "hlsl/declarations.h"
#include "preparation/passes.h"

namespace penumbra::preparation {

namespace {

constexpr std::string_view kSign = "penumbra_sign";
constexpr std::string_view kLit = "penumbra_lit";

bool defines(const TokenText& text, std::string_view name) {
  const auto& all = text.declarations();
  return std::any_of(all.begin(), all.end(), [&](const hlsl::Declaration& declaration) {
    return declaration.parameters_open != hlsl::Declaration::none && text.is(declaration.name, name);
  });
}

bool rename_calls(TokenText& text, std::string_view name, std::string_view to) {
  bool found = false;
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    if (!text.is(at, name) || !text.is(at + 1, "(") || text.is(at - 1, ".")) continue;
    if (!found && defines(text, name)) return false;
    text.replace(at, 1, to);
    found = true;
  }
  return found;
}

std::string sign_definition(const std::string& shape, const std::string& from, const std::string& value) {
  const std::string type = "int" + shape;
  return type + " " + std::string(kSign) + "(" + from + shape + " x) { return " + type + "(" + value +
         "); }\n";
}

std::string sign_of_matrix(const std::string& shape) {
  std::string rows;
  for (char row = '0'; row < shape[0]; ++row)
    rows += (rows.empty() ? "" : ", ") + std::string(kSign) + "(x[" + row + "])";
  return sign_definition(shape, "float", rows);
}

std::string sign_definitions() {
  std::string text;
  for (const char* shape : {"", "2", "3", "4"})
    text += sign_definition(shape, "float", "sign(x)") + sign_definition(shape, "int", "sign(x)") +
            sign_definition(shape, "uint", "min(x, 1u)");
  for (const char* shape : {"2x2", "2x3", "2x4", "3x2", "3x3", "3x4", "4x2", "4x3", "4x4"})
    text += sign_of_matrix(shape);
  return text;
}

// The power is of h, which is not negative where it is taken; abs() says so to the lint rules.
std::string lit_definition() {
  return "float4 " + std::string(kLit) +
         "(float l, float h, float m) { return float4(1, max(l, 0), l < 0 || h < 0 ? 0 : pow(abs(h), m), 1); "
         "}\n";
}

}  // namespace

// Intrinsic functions whose definitions differ between glslang and HLSL
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-intrinsic-functions), defined in the text:
//
// - sign() returns int, and 0 or 1 for an unsigned number; glslang's returns the argument's type, so sign(x)
//   / 2 is not an integer division.
// - lit()'s specular part is n.h raised to the power of m; glslang's multiplies.
//
// A function of the text with the name of the intrinsic is not changed.
void define_intrinsics(TokenText& text) {
  std::string definitions;
  if (rename_calls(text, "sign", kSign)) definitions += sign_definitions();
  if (rename_calls(text, "lit", kLit)) definitions += lit_definition();
  if (!definitions.empty()) text.insert(0, definitions);
  text.apply();
}

}  // namespace penumbra::preparation
