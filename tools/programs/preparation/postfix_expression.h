// How far an expression reaches around a token. Internal to this room.
#pragma once

#include <cstddef>

#include "preparation/token_text.h"

namespace penumbra::preparation {

// The first token of the postfix expression that ends at `last`: `f(x).a[i]` from its ']' back to `f`. npos
// when none ends there.
std::size_t postfix_begin(const TokenText& text, std::size_t last);

// The token after the postfix expression that begins at `first`, a name: over `.member`, `[index]`,
// `(arguments)`.
std::size_t postfix_end(const TokenText& text, std::size_t first);

// The ';', or the bracket that closes around it, which ends the expression that begins at `first`; npos at
// the end of the text.
std::size_t expression_end(const TokenText& text, std::size_t first);

// Whether a statement may begin at this token inside a function: after ';', '{', '}', else, do, a label, or
// the ')' of an if, for or while.
bool begins_statement(const TokenText& text, std::size_t at);

// Whether evaluating the tokens [first, end) twice is the same as once: no call, ++, -- or assignment in
// them.
bool may_be_repeated(const TokenText& text, std::size_t first, std::size_t end);

// The number of marks of the assignment operator at this token ("=" 1, "+=" 2, "<<=" 3), 0 when there is
// none.
std::size_t assignment_length(const TokenText& text, std::size_t at);

}  // namespace penumbra::preparation
