// Markdown files of which the program generates parts; people write the rest.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

// Returns text for a table's cell: a bar would end the cell, a line break the table, and HTML, links,
// emphasis, names of people and code would be interpreted. A character that does not stay in a line
// (text_line.h) becomes a space.
std::string markdown_cell(std::string_view text);

// These return the same as code within a line, which may be that of a table, and as a block of code in its
// fence. Neither ends before its text does, and no comment begins in it.
std::string markdown_code(std::string_view text);
std::string markdown_code_block(std::string_view language, std::string_view text);

// Returns a table of cells that are Markdown already. The first column and the last `texts_at_end` hold text,
// at the left; the others hold numbers, at the right.
std::string markdown_table(const std::vector<std::string>& heads,
                           const std::vector<std::vector<std::string>>& rows, std::size_t texts_at_end = 0);

// These return "<!-- NAME:begin -->" and "<!-- NAME:end -->", which enclose the block NAME.
std::string block_begin(std::string_view name);
std::string block_end(std::string_view name);

// Returns the text with the contents between the markers of `name` replaced by the block; the rest is
// unchanged. Throws InputError naming `file` if a marker is missing or duplicated, or the end precedes the
// beginning.
std::string replace_block(const std::string& text, std::string_view name, const std::string& block,
                          const std::string& file);

}  // namespace penumbra
