#include "preparation/macro_text.h"

#include <algorithm>

#include "hlsl/identifier.h"

namespace penumbra::preparation {

namespace {

bool is_white_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

class MacroScan {
 public:
  explicit MacroScan(const std::string& text) : text_(text) {}

  MacroText run() {
    while (at_ < text_.size()) {
      if (peek() == '#' && line_is_empty_) {
        directive();
      } else {
        step();
      }
    }
    return std::move(out_);
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void newline() {
    ++at_;
    ++line_;
    line_is_empty_ = true;
  }

  // Skips white space, comments and joined lines; returns true if there was any.
  bool gap() {
    if (is_white_space(peek())) {
      ++at_;
    } else if (peek() == '\\' && peek(1) == '\n') {
      at_ += 2;
      ++line_;
    } else if (peek() == '/' && peek(1) == '/') {
      while (at_ < text_.size() && peek() != '\n') skip_joined();
    } else if (peek() == '/' && peek(1) == '*') {
      const std::size_t end = std::min(text_.find("*/", at_ + 2), text_.size() - 2) + 2;
      line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                           text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      at_ = end;
    } else {
      return false;
    }
    return true;
  }

  void skip_joined() {
    if (peek() == '\\' && peek(1) == '\n') {
      ++at_;
      ++line_;
    }
    ++at_;
  }

  void skip_quoted() {
    for (++at_; at_ < text_.size() && peek() != '"' && peek() != '\n'; ++at_)
      if (peek() == '\\' && peek(1) != '\n') ++at_;
    at_ = std::min(at_ + (peek() == '"' ? 1 : 0), text_.size());
  }

  std::string_view word() {
    const std::size_t begin = at_;
    while (hlsl::continues_identifier(peek())) ++at_;
    return std::string_view(text_).substr(begin, at_ - begin);
  }

  void token() {
    const std::size_t begin = at_;
    if (hlsl::continues_identifier(peek())) {
      word();
    } else {
      ++at_;
    }
    out_.tokens.push_back({begin, std::string_view(text_).substr(begin, at_ - begin), region_});
  }

  // Makes one step outside of directives.
  void step() {
    if (peek() == '\n') return newline();
    if (gap()) return;
    line_is_empty_ = false;
    if (peek() == '"') return skip_quoted();
    token();
  }

  bool in_line() const { return at_ < text_.size() && peek() != '\n'; }

  void skip_gaps() {
    while (in_line() && gap()) {
    }
  }

  void directive() {
    ++region_;
    line_is_empty_ = false;
    ++at_;
    skip_gaps();
    if (word() == "define") {
      definition();
    } else {
      while (in_line()) {
        if (!gap()) skip_joined();
      }
    }
    ++region_;
  }

  void definition() {
    skip_gaps();
    MacroDefinition definition;
    definition.line = line_;
    definition.name = word();
    if (peek() == '(') definition.parameters = parameters();
    definition.body_begin = out_.tokens.size();
    while (in_line()) step();
    definition.body_end = out_.tokens.size();
    if (!definition.name.empty()) out_.definitions.push_back(definition);
  }

  std::size_t parameters() {
    std::size_t count = 0;
    for (++at_; in_line() && peek() != ')';) {
      if (gap()) continue;
      if (hlsl::continues_identifier(peek())) {
        word();
        ++count;
      } else {
        ++at_;
      }
    }
    if (peek() == ')') ++at_;
    return count;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool line_is_empty_ = true;
  std::size_t region_ = 0;
  MacroText out_;
};

}  // namespace

MacroText read_macro_text(const std::string& text) {
  return MacroScan(text).run();
}

}  // namespace penumbra::preparation
