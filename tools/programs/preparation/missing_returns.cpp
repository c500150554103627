#include "preparation/missing_returns.h"

#include <string>

#include "hlsl/declarations.h"
#include "preparation/resource_types.h"

namespace penumbra::preparation {

namespace {

bool is_storage(const TokenText& text, std::size_t at) {
  return text.is(at, "static") || text.is(at, "inline") || text.is(at, "precise") || text.is(at, "const");
}

bool returns(const TokenText& text, const hlsl::Declaration& function) {
  for (std::size_t at = function.open; at < function.close; ++at)
    if (text.is(at, "return")) return true;
  return false;
}

// Returns whether the name occurs outside of the function's definition.
bool is_mentioned(const TokenText& text, const hlsl::Declaration& function) {
  for (std::size_t at = 0; at < text.size(); ++at)
    if (at != function.name && text.is(at, text[function.name].spelling)) return true;
  return false;
}

// A texture or sampler has no zero value; such a function can only be removed.
void drop_unused(TokenText& text, const hlsl::Declaration& function) {
  if (is_mentioned(text, function)) return;
  text.note(function.name, hlsl::Severity::note,
            "'" + std::string(text[function.name].spelling) +
                "' has no return statement; nothing calls it, and it is left out");
  text.erase(function.first, function.last - function.first + 1);
}

}  // namespace

void return_from_empty_functions(TokenText& text) {
  for (const hlsl::Declaration& declaration : text.declarations()) {
    if (declaration.kind != hlsl::Declaration::Kind::function) continue;
    std::size_t type = declaration.type;
    while (is_storage(text, type)) ++type;
    if (text.is(type, "void") || returns(text, declaration)) continue;
    if (is_resource(text[type].spelling)) {
      drop_unused(text, declaration);
      continue;
    }
    text.note(
        declaration.name, hlsl::Severity::note,
        "'" + std::string(text[declaration.name].spelling) + "' has no return statement; it returns 0 here");
    text.insert(declaration.close, "return (" + text.spelled(type, declaration.name - type) + ")0;");
  }
  text.apply();
}

}  // namespace penumbra::preparation
