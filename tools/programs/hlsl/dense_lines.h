#pragma once

#include <string>
#include <string_view>

namespace penumbra::hlsl {

// Returns preprocessed text without its empty lines, with a #line directive only where one is needed: the
// same code at the same locations gives the same text, whatever was removed between. Each token keeps its
// file, line and column.
std::string dense_lines(std::string_view preprocessed);

}  // namespace penumbra::hlsl
