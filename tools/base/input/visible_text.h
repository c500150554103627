// Text of untrusted files and names as it may stand in a message: nothing in it moves a terminal's cursor,
// begins a line that a CI system takes for a command, or turns the direction of reading.
#pragma once

#include <string>
#include <string_view>

namespace penumbra {

// Control characters (U+0000 to U+001F, U+007F to U+009F), and those that turn the direction of text (U+202A
// to U+202E, U+2066 to U+2069), are written as escapes: "\n" as \n, others as \x1B or \u202E. The rest stays,
// bytes that are not UTF-8 included. A text of more than 4,000 bytes loses its middle: a key or a name may
// have megabytes.
std::string visible(std::string_view text);

std::string visible_line(std::string_view text);   // the same of a line of source, whose tabs stay
std::string visible_lines(std::string_view text);  // the same of a text of several lines

}  // namespace penumbra
