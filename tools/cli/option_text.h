// Parses option values with several parts: NAME=VALUE, A,B,C.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace penumbra::cli {

std::vector<std::string> split(const std::string& text, char separator);

// These throw InputError, naming the option, for a text of another form.
std::pair<std::string, std::string> name_and_value(const std::string& option, const std::string& text);
double number(const std::string& option, const std::string& text);  // finite

// Returns a word of a command, quoted for a shell if necessary.
std::string shell_word(const std::string& text);

// Throws InputError, naming the option, for a name or title that holds a control character or the beginning
// or end of a Markdown comment, because names are written into pages, captions and messages.
void require_plain_name(const std::string& option, const std::string& text);

}  // namespace penumbra::cli
