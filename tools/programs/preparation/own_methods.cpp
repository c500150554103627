#include "preparation/own_methods.h"

#include <set>
#include <string_view>

#include "hlsl/name_set.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

// Returns whether the name at this token is called, and neither declared nor a member of something else.
bool is_bare_call(const TokenText& text, std::size_t at) {
  static constexpr hlsl::NameSet statements("return", "else", "do", "case");
  if (!text.is(at + 1, "(") || text.is(at - 1, ".") || text.is(at - 1, ":")) return false;
  return !text.is_identifier(at - 1) || statements.contains(text[at - 1].spelling);
}

bool is_static(const TokenText& text, const hlsl::Declaration& function) {
  for (std::size_t at = function.first; at < function.name; ++at)
    if (text.is(at, "static")) return true;
  return false;
}

}  // namespace

void call_own_methods_by_this(TokenText& text) {
  std::set<std::string_view> free_functions;  // functions to which the unqualified name may also refer
  for (const hlsl::Declaration& declaration : text.types().declarations())
    if (declaration.kind == hlsl::Declaration::Kind::function)
      free_functions.insert(text[declaration.name].spelling);
  for (const auto& [name, type] : text.types().structs()) {
    std::set<std::string_view> own;
    for (const hlsl::Declaration& function : type.functions)
      if (!is_static(text, function)) own.insert(text[function.name].spelling);
    for (const hlsl::Declaration& function : type.functions)
      for (std::size_t at = function.open + 1; at < function.close; ++at)
        if (text.is_identifier(at) && own.contains(text[at].spelling) &&
            !free_functions.contains(text[at].spelling) && is_bare_call(text, at) &&
            !is_static(text, function))
          text.insert(at, "this.");
  }
  text.apply();
}

}  // namespace penumbra::preparation
