// Markdown that a program writes parts of: the rest of the file is a person's.
#pragma once

#include <string>
#include <string_view>

namespace penumbra {

// Text for a table's cell: a bar would end the cell, a line break the table, and HTML, links, emphasis and
// code would be obeyed. A control character becomes a blank.
std::string markdown_cell(std::string_view text);

// The same as code within a line, which may be that of a table; and as a block of code in its fence. Neither
// ends before its text does, and no comment begins in it.
std::string markdown_code(std::string_view text);
std::string markdown_code_block(std::string_view language, std::string_view text);

// "<!-- NAME:begin -->" and "<!-- NAME:end -->", between which the block NAME stands.
std::string block_begin(std::string_view name);
std::string block_end(std::string_view name);

// The text with what stands between the markers of `name` replaced by the block; the rest is kept byte by
// byte. Throws InputError naming `file` when a marker is missing, stands twice, or the end comes before the
// beginning.
std::string replace_block(const std::string& text, std::string_view name, const std::string& block,
                          const std::string& file);

}  // namespace penumbra
