#include "input/markdown.h"

#include <algorithm>

#include "input/input_error.h"

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

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

// Nothing can be escaped in code: control characters become spaces, and the beginning of a comment is split.
std::string harmless_code(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '-' && safe.ends_with("<!")) safe += ' ';
    safe += is_control(c) ? ' ' : c;
  }
  return safe;
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
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '|':
      case '[':
      case ']':
      case '*':
      case '`':
      case '\\':
        safe += '\\';
        safe += c;
        break;
      case '<':
        safe += "&lt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      default:
        safe += is_control(c) ? ' ' : c;
    }
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
