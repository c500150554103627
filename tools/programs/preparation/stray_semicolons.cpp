#include "preparation/stray_semicolons.h"

#include "hlsl/declarations.h"

namespace penumbra::preparation {

namespace {

// Drops a ';' between the braces of a struct or cbuffer: at the beginning, after another, or after a member
// function's body.
void drop_among_members(TokenText& text, const hlsl::Declaration& declaration) {
  for (std::size_t at = declaration.open + 1; at < declaration.close; ++at) {
    const bool stray =
        text.is(at, ";") && (text.is(at - 1, ";") || text.is(at - 1, "{") || text.is(at - 1, "}"));
    if (stray) text.erase(at, 1);
    const bool body = text.is(at, "{") && text.matching_bracket(at) != npos;
    if (body) at = text.matching_bracket(at);
  }
}

}  // namespace

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
