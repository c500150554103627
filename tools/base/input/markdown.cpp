#include "input/markdown.h"

#include <algorithm>

#include "input/input_error.h"
#include "input/text_line.h"

namespace penumbra {
namespace {

std::size_t only_position(const std::string& text, const std::string& marker, std::string_view name,
                          const std::string& file) {
  const std::size_t first = text.find(marker);
  if (first == std::string::npos) {
    throw InputError(file, "the marker '" + marker + "' is missing",
                     "put " + block_begin(name) + " and " + block_end(name) + " where the figures belong");
  }
  if (text.find(marker, first + 1) != std::string::npos) {
    throw InputError(file, "the marker '" + marker + "' appears twice", "remove one of them");
  }
  return first;
}

// Nothing can be escaped in code, so the beginning of a comment is split.
std::string harmless_code(std::string_view text) {
  std::string safe;
  for (const char c : in_one_line(text)) {
    if (c == '-' && safe.ends_with("<!")) safe += ' ';
    safe += c;
  }
  return safe;
}

bool is_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// Returns whether the '_' at this place could end an emphasis: no word continues behind it. Those that begin
// one, as in names of keywords, are read as they are where none can end it.
bool ends_emphasis(const std::string& line, std::size_t at) {
  return line[at] == '_' && (at + 1 == line.size() || !is_letter_or_digit(line[at + 1]));
}

std::string more_backticks_than_in(std::string_view text, std::size_t least) {
  std::size_t longest = 0;
  std::size_t run = 0;
  for (const char c : text) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  return std::string(std::max(least, longest + 1), '`');
}

}  // namespace

std::string markdown_cell(std::string_view text) {
  constexpr std::string_view kEscaped = "|[]*`\\~";
  const std::string line = in_one_line(text);
  std::string safe;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (c == '<')
      safe += "&lt;";
    else if (c == '&')
      safe += "&amp;";
    else if (c == '@')
      safe += "&#64;";  // GitHub would notify the person of that name
    else if (c == ':' && line.compare(at, 3, "://") == 0)
      safe += "&#58;";  // an address is a link
    else
      safe += (kEscaped.find(c) != std::string_view::npos || ends_emphasis(line, at) ? "\\" : "") +
              std::string(1, c);
  }
  return safe;
}

std::string markdown_code(std::string_view text) {
  const std::string code = harmless_code(text);
  const std::string fence = more_backticks_than_in(code, 1);
  const bool touches = code.starts_with('`') || code.ends_with('`');
  std::string safe = fence + (touches ? " " : "");
  for (const char c : code) safe += c == '|' ? "\\|" : std::string(1, c);
  return safe + (touches ? " " : "") + fence;
}

std::string markdown_code_block(std::string_view language, std::string_view text) {
  const std::string code = harmless_code(text);
  const std::string fence = more_backticks_than_in(code, 3);
  return fence + std::string(language) + "\n" + code + "\n" + fence + "\n";
}

std::string markdown_table(const std::vector<std::string>& heads,
                           const std::vector<std::vector<std::string>>& rows, std::size_t texts_at_end) {
  std::string text;
  const auto add = [&text](const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) text += "| " + cell + " ";
    text += "|\n";
  };
  add(heads);
  for (std::size_t i = 0; i < heads.size(); ++i)
    text += i == 0 || i + texts_at_end >= heads.size() ? "|:--" : "|--:";
  text += "|\n";
  for (const std::vector<std::string>& row : rows) add(row);
  return text;
}

std::string block_begin(std::string_view name) {
  return "<!-- " + std::string(name) + ":begin -->";
}

std::string block_end(std::string_view name) {
  return "<!-- " + std::string(name) + ":end -->";
}

std::string replace_block(const std::string& text, std::string_view name, const std::string& block,
                          const std::string& file) {
  const std::size_t begin = only_position(text, block_begin(name), name, file) + block_begin(name).size();
  const std::size_t end = only_position(text, block_end(name), name, file);
  if (end < begin) {
    throw InputError(file, "the end marker '" + block_end(name) + "' comes before the begin marker");
  }
  return text.substr(0, begin) + "\n" + block + text.substr(end);
}

}  // namespace penumbra
