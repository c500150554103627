#pragma once

#include <string>
#include <string_view>

namespace penumbra::hlsl {

// Preprocessed text without its empty lines, and with a #line directive only where one is needed: the same
// code at the same places is the same text, whatever was left out between it. Code keeps file, line and
// column.
std::string dense_lines(std::string_view preprocessed);

}  // namespace penumbra::hlsl
