// The extent of the expression around a token. Internal to this folder.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

// Returns the first token of the postfix expression that ends at `last`: `f(x).a[i]` from its ']' back to
// `f`. Returns npos if none ends there.
std::size_t postfix_begin(const TokenText& text, std::size_t last);

// Returns the token after the postfix expression that begins at `first`, a name: over `.member`, `[index]`,
// `(arguments)`.
std::size_t postfix_end(const TokenText& text, std::size_t first);

// Returns the ';' or the closing bracket that ends the expression that begins at `first`; npos at the end of
// the text.
std::size_t expression_end(const TokenText& text, std::size_t first);

// Returns whether a statement may begin at this token inside a function: after ';', '{', '}', else, do, a
// label, or the ')' of an if, for or while.
bool begins_statement(const TokenText& text, std::size_t at);

// Returns whether the tokens [first, end) have no side effects, so that they may be evaluated twice: no call,
// ++, -- or assignment.
bool may_be_repeated(const TokenText& text, std::size_t first, std::size_t end);

// Returns the number of characters of the assignment operator at this token ("=" 1, "+=" 2, "<<=" 3); 0 if
// there is none.
std::size_t assignment_length(const TokenText& text, std::size_t at);

// The elements of a bracketed list: the arguments of a call, the values of an initialiser.
//
// An element with the tokens [first, end).
struct ListElement {
  std::size_t first;
  std::size_t end;
};

// Returns the elements between the bracket at `open`, which must have a match, and its match. Empty ones are
// skipped.
std::vector<ListElement> list_elements(const TokenText& text, std::size_t open);

}  // namespace penumbra::preparation
