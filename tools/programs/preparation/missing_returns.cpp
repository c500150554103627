#include "hlsl/declarations.h"
#include "preparation/passes.h"
#include "preparation/resource_types.h"

namespace penumbra::preparation {

namespace {

bool is_storage(const TokenText& text, std::size_t at) {
  return text.is_any(at, "static", "inline", "precise", "const");
}

bool returns(const TokenText& text, const hlsl::Declaration& function) {
  return text.has(function.open, function.close, "return");
}

// Returns whether the name occurs outside of the function's definition.
bool is_mentioned(const TokenText& text, const hlsl::Declaration& function) {
  for (std::size_t at = 0; at < text.size(); ++at)
    if (at != function.name && text.is(at, text.word(function.name))) return true;
  return false;
}

// A texture or sampler has no zero value; such a function can only be removed.
void drop_unused(TokenText& text, const hlsl::Declaration& function) {
  if (is_mentioned(text, function)) return;
  text.note(
      function.name, hlsl::Severity::note,
      "'" + text.name(function.name) + "' has no return statement; nothing calls it, and it is left out");
  text.erase(function.first, function.last - function.first + 1);
}

}  // namespace

// A function with a return type and no return statement, because all of its returns are in branches of
// disabled keywords. Unity's compilers accept it if nothing calls it; glslang reports "must return a value".
// It returns zero instead, with a note; a function of texture or sampler type, for which there is no zero, is
// removed if its name is not used elsewhere. A function that returns on some paths is left to the compilers.
void return_from_empty_functions(TokenText& text) {
  for (const hlsl::Declaration& declaration : text.declarations()) {
    if (declaration.kind != hlsl::Declaration::Kind::function) continue;
    std::size_t type = declaration.type;
    while (is_storage(text, type)) ++type;
    if (text.is(type, "void") || returns(text, declaration)) continue;
    if (is_resource(text.word(type))) {
      drop_unused(text, declaration);
      continue;
    }
    text.note(declaration.name, hlsl::Severity::note,
              "'" + text.name(declaration.name) + "' has no return statement; it returns 0 here");
    text.insert(declaration.close, "return (" + text.spelled(type, declaration.name - type) + ")0;");
  }
  text.apply();
}

}  // namespace penumbra::preparation
