#include "shaderlab/pragma_lines.h"

#include <utility>

#include "shaderlab/characters.h"

namespace penumbra::shaderlab {

namespace {

class PragmaScan {
 public:
  explicit PragmaScan(std::string_view text) : text_(text) {}

  std::vector<PragmaLine> run() {
    while (at_.offset < text_.size()) line();
    return std::move(lines_);
  }

 private:
  bool starts(std::string_view with) const { return text_.substr(at_.offset, with.size()) == with; }
  bool at_end() const { return at_.offset >= text_.size(); }
  char here() const { return text_[at_.offset]; }

  void advance(std::size_t count = 1) {
    for (; count > 0 && !at_end(); --count) {
      if (text_[at_.offset++] == '\n') {
        ++at_.line;
        at_.column = 1;
      } else {
        ++at_.column;
      }
    }
  }

  // Skips blanks, joined lines and comments; returns false at the end of the line, which it leaves in place.
  bool skip_blanks() {
    while (!at_end() && here() != '\n') {
      if (is_blank(here())) {
        advance();
      } else if (starts("\\\n")) {
        advance(2);
      } else if (starts("/*")) {
        block_comment();
      } else if (starts("//")) {
        line_comment_ = true;
        rest_of_line();
      } else {
        return true;
      }
    }
    return false;
  }

  void block_comment() {
    advance(2);
    while (!at_end() && !starts("*/")) advance();
    advance(2);
  }

  // Skips to the newline, over joined lines.
  void rest_of_line() {
    while (!at_end() && here() != '\n') advance(starts("\\\n") ? 2 : 1);
  }

  void code_line() {
    while (skip_blanks()) {
      if (here() == '"') {
        string();
      } else {
        advance();
      }
    }
  }

  void string() {
    advance();
    while (!at_end() && here() != '"' && here() != '\n') advance();
    if (!at_end() && here() == '"') advance();
  }

  Name word() {
    const Place begin = at_;
    while (!at_end() && !is_blank(here()) && here() != '\n' && !starts("\\\n") && !starts("//") &&
           !starts("/*"))
      advance();
    return {std::string(text_.substr(begin.offset, at_.offset - begin.offset)), begin};
  }

  void line() {
    line_comment_ = false;
    if (skip_blanks()) {
      if (here() == '#') {
        directive();
      } else {
        code_line();
      }
    }
    advance();
  }

  void directive() {
    PragmaLine pragma{at_, at_, {}, false};
    advance();
    std::vector<Name> words;
    while (skip_blanks()) {
      words.push_back(word());
      pragma.end = at_;
      if (words.front().text != "pragma") return rest_of_directive();
    }
    if (words.empty()) return;
    words.erase(words.begin());
    pragma.words = std::move(words);
    pragma.has_line_comment = line_comment_;
    lines_.push_back(std::move(pragma));
  }

  void rest_of_directive() { code_line(); }

  std::string_view text_;
  Place at_{1, 1, 0};
  bool line_comment_ = false;
  std::vector<PragmaLine> lines_;
};

}  // namespace

std::vector<PragmaLine> pragma_lines(std::string_view text) {
  return PragmaScan(text).run();
}

}  // namespace penumbra::shaderlab
