#include <algorithm>
#include <array>
#include <unordered_set>

#include "hlsl/declarations.h"
#include "preparation/passes.h"
#include "preparation/postfix_expression.h"
#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

void as_uint(TokenText& text, const ListElement& argument) {
  const bool literal = argument.end - argument.first == 1 && text.is_number(argument.first);
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

std::string lit_definition() {
  return "float4 " + std::string(kLit) +
         "(float l, float h, float m) { return float4(1, max(l, 0), l < 0 || h < 0 ? 0 : pow(h, m), 1); }\n";
}

struct Absent {
  std::string_view name;
  std::string_view instead;
};

constexpr std::array absent{
    Absent{"msad4", "write out the sums of absolute differences"},
    Absent{"GetRenderTargetSampleCount", "pass the number in a constant buffer"},
    Absent{"GetRenderTargetSamplePosition", "pass the positions in a constant buffer"},
    Absent{"InterlockedCompareStore", "write it as a statement of its own, or InterlockedCompareExchange()"},
};

}  // namespace

// Calls of intrinsics for which glslang emits SPIR-V that does not validate:
//
// - mad(a, b, c) of integers becomes an instruction for floats: rewritten to ((a) * (b) + (c)), which HLSL
//   allows for every mad (docs "mad": precise or not is the implementation's choice).
// - ldexp(x, e) with a float e becomes Ldexp, which takes an integer exponent: rewritten to ((x) * exp2(e)),
//   HLSL's own definition.
// - The values of a byte address buffer's Interlocked methods are uint: int literals become uint.
//
// - InterlockedCompareStore, which glslang does not have, becomes InterlockedCompareExchange with a variable
//   for the old value, where the call is a statement of its own.
//
// A function of the text with the name of the intrinsic is not changed.
void write_out_intrinsic_calls(TokenText& text) {
  const std::string variable = text.free_name("penumbra_old_value");
  for (std::size_t at = 1; at + 1 < text.size(); ++at) {
    if (!text.is_identifier(at) || !text.is(at + 1, "(") || text.matching_bracket(at + 1) == npos) continue;
    const std::string_view name = text.word(at);
    if (text.is(at - 1, ".") && name.substr(0, 11) == "Interlocked")
      give_uint_values(text, name, list_elements(text, at + 1));
    if (name == "InterlockedCompareStore") exchange(text, at, variable);
  }
  text.apply();
}

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

void refuse_absent_intrinsics(TokenText& text) {
  std::unordered_set<std::string_view> own;
  for (const FunctionType& function : text.types().functions()) own.insert(text.word(function.name));
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    if (!text.is_identifier(at) || !text.is(at + 1, "(")) continue;
    for (const Absent& function : absent) {
      if (!text.is(at, function.name) || own.contains(function.name)) continue;
      text.error(at, "'" + std::string(function.name) +
                         "' is HLSL, but is not supported: " + std::string(function.instead));
      text.replace(at, 1, "penumbra_" + std::string(function.name));  // glslang crashes on some of them
    }
  }
  text.apply();
}

}  // namespace penumbra::preparation
