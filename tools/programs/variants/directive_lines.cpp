#include "variants/directive_lines.h"

#include <cstddef>

namespace penumbra::variants {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

struct PlacedCharacter {
  char character = 0;
  int line = 0;
  int column = 0;
};

// Reads one logical line after another: lines joined, each comment replaced by a space.
class LogicalLines {
 public:
  explicit LogicalLines(std::string_view text) : text_(text) {}

  // Returns false at the end of the text. Lines that are not directives are skipped.
  bool next(std::vector<PlacedCharacter>& line) {
    line.clear();
    if (at_ == text_.size()) return false;
    bool keep = true;
    bool in_text = false;
    while (at_ < text_.size()) {
      if (skip_joint()) continue;
      const char c = text_[at_];
      if (c == '\n') {
        step();
        return true;
      }
      if (!in_text && skip_comment(line, keep)) continue;
      if (c == '"') in_text = !in_text;
      if (line.empty() && !is_blank(c) && c != '#') keep = false;
      if (keep && !(line.empty() && is_blank(c))) line.push_back({c, line_, column_});
      step();
    }
    return true;
  }

 private:
  void step() {
    if (text_[at_++] == '\n') {
      ++line_;
      column_ = 1;
    } else {
      ++column_;
    }
  }

  bool skip_joint() {
    if (text_[at_] != '\\') return false;
    const std::size_t end = at_ + (text_.substr(at_ + 1, 1) == "\r" ? 2 : 1);
    if (text_.substr(end, 1) != "\n") return false;
    while (at_ <= end) step();
    return true;
  }

  bool skip_comment(std::vector<PlacedCharacter>& line, bool keep) {
    const std::string_view opening = text_.substr(at_, 2);
    if (opening == "//") {
      while (at_ < text_.size() && text_[at_] != '\n') {
        if (!skip_joint()) step();
      }
      return true;
    }
    if (opening != "/*") return false;
    if (keep && !line.empty()) line.push_back({' ', line_, column_});
    step();
    step();
    while (at_ < text_.size() && text_.substr(at_, 2) != "*/") step();
    for (int i = 0; i < 2 && at_ < text_.size(); ++i) step();
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
};

DirectiveLine read_directive(const std::vector<PlacedCharacter>& line) {
  DirectiveLine directive;
  directive.line = line.front().line;
  directive.column = line.front().column;
  std::size_t at = 1;
  while (at < line.size() && is_blank(line[at].character)) ++at;
  while (at < line.size() && is_name_character(line[at].character)) directive.name += line[at++].character;
  while (at < line.size() && is_blank(line[at].character)) ++at;
  bool in_word = false;
  for (; at < line.size(); ++at) {
    const PlacedCharacter& c = line[at];
    directive.rest += c.character;
    if (is_blank(c.character)) {
      in_word = false;
      continue;
    }
    if (!in_word) directive.words.push_back({{}, c.line, c.column});
    directive.words.back().text += c.character;
    in_word = true;
  }
  while (!directive.rest.empty() && is_blank(directive.rest.back())) directive.rest.pop_back();
  return directive;
}

}  // namespace

std::vector<DirectiveLine> directive_lines(std::string_view text) {
  std::vector<DirectiveLine> directives;
  std::vector<PlacedCharacter> line;
  LogicalLines lines(text);
  while (lines.next(line)) {
    if (!line.empty() && line.front().character == '#') directives.push_back(read_directive(line));
  }
  return directives;
}

}  // namespace penumbra::variants
