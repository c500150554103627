#include "preparation/bare_source.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "hlsl/identifier.h"

namespace penumbra::preparation {

namespace {

class BareSource {
 public:
  explicit BareSource(std::string_view text) : text_(text) { out_.reserve(text.size()); }

  std::string run() {
    while (at_ < text_.size()) step();
    return std::move(out_);
  }

 private:
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool starts(std::string_view with) const { return text_.compare(at_, with.size(), with) == 0; }

  void take(std::size_t count) {
    out_.append(text_, at_, count);
    at_ += count;
  }

  void step() {
    const char c = text_[at_];
    if (c == '\n') {
      take(1);
      in_directive_ = false;
      line_is_empty_ = true;
    } else if (c == '\\' && peek(1) == '\n') {
      joined_lines();
    } else if (hlsl::is_blank(c) && line_is_empty_) {
      skip_blanks();
    } else if (starts("//")) {
      line_comment();
    } else if (starts("/*")) {
      block_comment();
    } else if (c == '"') {
      take(end_of_text() - at_);
    } else if (c == '#' && line_is_empty_) {
      directive();
    } else {
      line_is_empty_ = false;
      take(end_of_plain() - at_);
    }
  }

  // Outside directives, a plain newline replaces a joined one if no token continues over the end of the line.
  void joined_lines() {
    const bool blank_before =
        out_.empty() || hlsl::is_blank(out_.back()) || (out_.back() == '\n' && !out_.ends_with("\\\n"));
    at_ += 2;
    const bool blank_after = skip_blanks();
    const bool plain =
        !in_directive_ && (blank_before || blank_after) && (at_ == text_.size() || text_[at_] != '#');
    out_ += plain ? "\n" : "\\\n";
    if (blank_after && !plain) out_ += ' ';
  }

  bool skip_blanks() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && hlsl::is_blank(text_[at_])) ++at_;
    return at_ > begin;
  }

  // Skips at least one character, up to the next one of interest.
  std::size_t end_of_plain() const { return std::min(text_.find_first_of("\n\\/\"", at_ + 1), text_.size()); }

  // The comment includes the lines that '\' joins to it.
  void line_comment() {
    for (; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
      if (text_[at_] != '\\' || peek(1) != '\n') continue;
      out_ += "\\\n";  // in a directive the next line would be code
      ++at_;
    }
  }

  void block_comment() {
    const std::size_t close = text_.find("*/", at_ + 2);
    const std::size_t end = close == std::string_view::npos ? text_.size() : close + 2;
    const std::string_view comment = text_.substr(at_, end - at_);
    const auto lines = std::count(comment.begin(), comment.end(), '\n');
    const std::size_t after = std::min(text_.find_first_not_of(" \t", end), text_.size());
    const bool hides_mark = after < text_.size() && text_[after] == '#' && !line_is_empty_;
    if (close == std::string_view::npos || (lines > 0 && (in_directive_ || hides_mark)))
      return take(comment.size());
    if (lines == 0 && !line_is_empty_) out_ += ' ';
    out_.append(static_cast<std::size_t>(lines), '\n');
    at_ = end;
  }

  // A string literal ends with its line at the latest.
  std::size_t end_of_text() const {
    std::size_t at = at_ + 1;
    while (at < text_.size() && text_[at] != '"' && text_[at] != '\n')
      at += text_[at] == '\\' && at + 1 < text_.size() && text_[at + 1] != '\n' ? 2 : 1;
    return at < text_.size() && text_[at] == '"' ? at + 1 : std::min(at, text_.size());
  }

  void directive() {
    line_is_empty_ = false;
    in_directive_ = true;
    const std::size_t word = std::min(text_.find_first_not_of(" \t", at_ + 1), text_.size());
    constexpr std::array<std::string_view, 4> verbatim{"include", "error", "pragma", "line"};
    const bool stays = std::any_of(verbatim.begin(), verbatim.end(), [&](std::string_view name) {
      return text_.compare(word, name.size(), name) == 0;
    });
    take((stays ? end_of_line() : word) - at_);
  }

  std::size_t end_of_line() const {
    std::size_t end = at_;
    while (end < text_.size() && (text_[end] != '\n' || text_[end - 1] == '\\')) ++end;
    return end;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool line_is_empty_ = true;  // the current line has no code so far
  bool in_directive_ = false;
  std::string out_;
};

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

std::string bare_source(std::string_view text) {
  return BareSource(text).run();
}

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
