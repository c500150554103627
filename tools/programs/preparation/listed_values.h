// The values of an initialiser list. Internal to this folder.
#pragma once

#include <cstddef>
#include <vector>

#include "preparation/list_elements.h"
#include "preparation/token_text.h"

namespace penumbra::preparation {

// An expression of a list, without the braces around it.
struct ListedValue : ListElement {
  std::size_t numbers = 0;  // 0 if not known
};

// Returns the values between the '{' at `open`, which must have a match, and its match, including those of
// nested lists.
std::vector<ListedValue> flat_values(const TokenText& text, std::size_t open);

// Returns the number of scalars in the expression [first, end); 0 if unknown.
std::size_t numbers_of(const TokenText& text, std::size_t first, std::size_t end);

}  // namespace penumbra::preparation
