#include "hlsl/diagnostic.h"

#include <algorithm>
#include <utility>

#include "input/visible_text.h"

namespace penumbra::hlsl {

namespace {

const char* severity_name(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      break;
  }
  return "error";
}

// Returns white space in place of the text before a caret, one for each character of UTF-8; tabs are kept, so
// that it is aligned at any tab width.
std::string blanks_for(std::string_view text) {
  std::string blanks;
  for (const char c : text)
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) blanks += c == '\t' ? '\t' : ' ';
  return blanks;
}

constexpr std::size_t kLongestShown = 160;

struct Excerpt {
  std::string line;
  std::string before_caret;
};

// Returns the part around the column of a line that is too long for a message (one of generated code may have
// a megabyte). It is cut between UTF-8 characters.
Excerpt excerpt_of(std::string_view line, int column) {
  const auto inside_character = [&](std::size_t at) {
    return at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0U) == 0x80U;
  };
  const auto asked = static_cast<std::size_t>(std::max(column, 1) - 1);
  const std::size_t at = std::min(line.size(), asked);
  std::size_t begin = 0;
  std::size_t end = line.size();
  if (line.size() > kLongestShown) {
    begin = std::min(at < kLongestShown / 2 ? 0 : at - kLongestShown / 2, line.size() - kLongestShown);
    while (inside_character(begin)) ++begin;
    end = begin + kLongestShown;
    while (inside_character(end)) ++end;
    end = std::min(end, line.size());
  }
  std::string before = (begin > 0 ? "..." : "") + visible_line(line.substr(begin, at - begin));
  std::string shown = (begin > 0 ? "..." : "") + visible_line(line.substr(begin, end - begin)) +
                      (end < line.size() ? "..." : "");
  // A missing token may be after the line's end; a report from elsewhere may contain any column.
  before.append(std::min(asked - at, kLongestShown), ' ');
  return {std::move(shown), std::move(before)};
}

}  // namespace

std::string format(const Diagnostic& diagnostic) {
  std::string text = visible(diagnostic.file);
  if (diagnostic.line > 0) text += ":" + std::to_string(diagnostic.line);
  if (diagnostic.line > 0 && diagnostic.column > 0) text += ":" + std::to_string(diagnostic.column);
  if (!text.empty()) text += ": ";
  text += std::string(severity_name(diagnostic.severity)) + ": " + visible(diagnostic.message);
  if (diagnostic.line == 0 || diagnostic.source_line.empty()) return text;
  const Excerpt excerpt = excerpt_of(diagnostic.source_line, diagnostic.column);
  text += "\n    " + excerpt.line;
  if (diagnostic.column > 0) text += "\n    " + blanks_for(excerpt.before_caret) + "^";
  return text;
}

bool has_errors(const std::vector<Diagnostic>& diagnostics) {
  return first_error(diagnostics) != nullptr;
}

const Diagnostic* first_error(const std::vector<Diagnostic>& diagnostics) {
  const auto found = std::find_if(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& diagnostic) {
    return diagnostic.severity == Severity::error;
  });
  return found == diagnostics.end() ? nullptr : &*found;
}

}  // namespace penumbra::hlsl
