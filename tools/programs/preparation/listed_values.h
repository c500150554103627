// The values of an initialiser list. Internal to this room.
#pragma once

#include <cstddef>
#include <vector>

#include "preparation/list_elements.h"
#include "preparation/token_text.h"

namespace penumbra::preparation {

// One expression of a list, whatever braces stand around it.
struct ListedValue : ListElement {
  std::size_t numbers = 0;  // 0: not known
};

// Those between the '{' at `open` and its partner, which it must have, those of the lists in it included.
std::vector<ListedValue> flat_values(const TokenText& text, std::size_t open);

// How many scalars the expression [first, end) consists of; 0: not known.
std::size_t numbers_of(const TokenText& text, std::size_t first, std::size_t end);

}  // namespace penumbra::preparation
