#include "preparation/include_guard.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace penumbra::preparation {

namespace {

constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

struct Line {
  bool empty = true;
  std::string_view directive;  // "ifndef"; empty for code
  std::string_view rest;
};

Line read_line(std::string_view line) {
  line = trimmed(line);
  if (line.empty() || line.front() != '#') return {line.empty(), {}, {}};
  line = trimmed(line.substr(1));
  const std::size_t end = std::min(line.find_first_of(" \t(!"), line.size());
  return {false, line.substr(0, end), trimmed(line.substr(end))};
}

class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  // Returns nothing at the end. A '\' at its end continues the line.
  std::optional<Line> next() {
    if (text_.empty()) return std::nullopt;
    const std::size_t end = text_.find('\n');
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    const bool goes_on = line.ends_with('\\');
    const bool is_continued = std::exchange(continued_, goes_on);
    return is_continued ? Line{false, {}, {}} : read_line(line);
  }

  std::optional<Line> next_with_text() {
    std::optional<Line> line = next();
    while (line && line->empty) line = next();
    return line;
  }

 private:
  std::string_view text_;
  bool continued_ = false;
};

bool opens(const Line& line) {
  return line.directive == "if" || line.directive == "ifdef" || line.directive == "ifndef";
}

}  // namespace

std::string include_guard(std::string_view bare) {
  Lines lines(bare);
  const std::optional<Line> condition = lines.next_with_text();
  if (!condition || condition->directive != "ifndef" || condition->rest.empty()) return {};
  const std::optional<Line> definition = lines.next_with_text();
  const std::string_view guard = condition->rest;
  if (!definition || definition->directive != "define") return {};
  if (trimmed(definition->rest.substr(0, definition->rest.find_first_of(blanks))) != guard) return {};
  int depth = 1;
  while (const std::optional<Line> line = lines.next()) {
    if (line->empty) continue;
    if (depth == 0) return {};  // it is followed by other tokens
    if (opens(*line)) ++depth;
    if (line->directive == "endif") --depth;
    if (depth == 1 && (line->directive == "else" || line->directive == "elif")) return {};
  }
  return depth == 0 ? std::string(guard) : std::string();
}

std::set<std::string> undefined_macros(std::string_view bare) {
  std::set<std::string> names;
  Lines lines(bare);
  while (const std::optional<Line> line = lines.next())
    if (line->directive == "undef") names.emplace(line->rest);
  return names;
}

}  // namespace penumbra::preparation
