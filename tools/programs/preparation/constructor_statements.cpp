#include "preparation/constructor_statements.h"

#include "hlsl/declarations.h"
#include "preparation/declarators.h"
#include "preparation/postfix_expression.h"

namespace penumbra::preparation {

namespace {

void wrap_in(TokenText& text, const hlsl::Declaration& function) {
  for (std::size_t at = function.open + 1; at < function.close; ++at) {
    if (!text.is_identifier(at) || !text.is(at + 1, "(") || !is_number_type(text[at].spelling)) continue;
    if (!begins_statement(text, at)) continue;
    const std::size_t end = expression_end(text, at);
    if (end == npos || !text.is(end, ";")) continue;
    text.insert(at, "(");
    text.insert(end, ")");
    at = end;
  }
}

}  // namespace

void wrap_constructor_statements(TokenText& text) {
  for (const hlsl::Declaration& declaration : text.declarations())
    if (declaration.kind == hlsl::Declaration::Kind::function) wrap_in(text, declaration);
  text.apply();
}

}  // namespace penumbra::preparation
