#include "hlsl/expanded_text.h"

#include <algorithm>
#include <sstream>

#include "hlsl/tokens.h"

namespace penumbra::hlsl {

namespace {

// The directive is #line N "file".
bool take_line_directive(const std::string& text, CodeLine& place) {
  if (text.compare(0, 6, "#line ") != 0) return false;
  place.line = std::atoi(text.c_str() + 6);
  const std::size_t open = text.find('"');
  const std::size_t close = text.rfind('"');
  if (open != std::string::npos && close > open) place.file = text.substr(open + 1, close - open - 1);
  return true;
}

// Moves from `at`, the current location of the text, to that of the next code.
void go_to(const LinePlace& place, LinePlace& at, std::string& out) {
  const bool near =
      at.file == place.file && at.line <= place.line && place.line - at.line <= most_empty_lines;
  if (near) {
    out.append(static_cast<std::size_t>(place.line - at.line), '\n');
  } else {
    out.append("#line ").append(std::to_string(place.line));
    if (!place.file.empty() || !at.file.empty()) out.append(" \"").append(place.file).append("\"");
    out.push_back('\n');
  }
  at = place;
}

}  // namespace

std::vector<CodeLine> expanded_lines(const std::string& preprocessed, const std::string& main_file) {
  std::vector<CodeLine> lines;
  std::istringstream stream(preprocessed);
  CodeLine place{main_file, 1, {}};
  for (std::string text; std::getline(stream, text);) {
    if (take_line_directive(text, place)) continue;
    lines.push_back({place.file, place.line, text});
    ++place.line;
  }
  return lines;
}

std::string dense_lines(std::string_view preprocessed) {
  std::string out;
  out.reserve(preprocessed.size());
  LinePlace next;
  LinePlace at;
  for (std::size_t begin = 0; begin < preprocessed.size();) {
    const std::size_t end = std::min(preprocessed.find('\n', begin), preprocessed.size());
    const std::string_view line = preprocessed.substr(begin, end - begin);
    begin = end + 1;
    if (take_line_directive(line, next)) continue;
    if (line.find_first_not_of(" \t\r") != std::string_view::npos) {
      go_to(next, at, out);
      out.append(line).push_back('\n');
      ++at.line;
    }
    ++next.line;
  }
  return out;
}

}  // namespace penumbra::hlsl
