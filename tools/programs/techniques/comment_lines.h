// Comments of emitted HLSL.
#pragma once

#include <string>
#include <string_view>

namespace penumbra::techniques {

// Returns the words of a text in lines of at most 120 columns, or of one word where that is longer. The first
// line begins with `first`, the others with `next`, such as "//"; a line ends with '\n'.
std::string comment_lines(const std::string& text, std::string_view first, std::string_view next);

}  // namespace penumbra::techniques
