// Escapes text of untrusted files and names for messages: it cannot move a terminal's cursor, begin a line
// that a CI system interprets as a command, or change the direction of text.
#pragma once

#include <string>
#include <string_view>

namespace penumbra {

// A character that does not stay in a line (text_line.h) is written as an escape: "\n" as \n, others as \x1B
// or \u202E. So are the first ':' of a text that begins with "::", and the '[' of "##[", which GitHub Actions
// take for commands. The rest is unchanged. The middle of a text of more than 4,000 bytes is removed: a key
// or a name may have megabytes.
std::string visible(std::string_view text);

std::string visible_line(std::string_view text);   // the same for a source line, whose tabs are kept
std::string visible_lines(std::string_view text);  // the same for several lines

}  // namespace penumbra
