// The elements of a bracketed list: the arguments of a call, the values of an initialiser. Internal to this
// folder.
#pragma once

#include <cstddef>
#include <vector>

#include "preparation/token_text.h"

namespace penumbra::preparation {

// An element with the tokens [first, end).
struct ListElement {
  std::size_t first;
  std::size_t end;
};

// Returns the elements between the bracket at `open`, which must have a match, and its match. Empty ones are
// skipped.
std::vector<ListElement> list_elements(const TokenText& text, std::size_t open);

}  // namespace penumbra::preparation
