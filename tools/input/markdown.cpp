#include "input/markdown.h"

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

}  // namespace

std::string markdown_cell(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '|':
        safe += "\\|";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      case '\n':
      case '\r':
        safe += ' ';
        break;
      default:
        safe += c;
    }
  }
  return safe;
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
