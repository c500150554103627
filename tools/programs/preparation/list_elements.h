// The elements of a list in brackets: the arguments of a call, the values of an initialiser. Internal to this
// room.
#pragma once

#include <cstddef>
#include <vector>

#include "preparation/token_text.h"

namespace penumbra::preparation {

// Of the tokens [first, end).
struct ListElement {
  std::size_t first;
  std::size_t end;
};

// Those between the bracket at `open`, which has a partner, and its partner. Empty ones are left out.
std::vector<ListElement> list_elements(const TokenText& text, std::size_t open);

}  // namespace penumbra::preparation
