#include "hlsl/dense_lines.h"

#include <algorithm>

#include "hlsl/line_directive.h"

namespace penumbra::hlsl {

namespace {

// Up to this many empty lines are shorter than a directive.
constexpr int most_empty_lines = 16;

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
