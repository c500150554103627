#include "shaderlab/lexer.h"

#include <utility>

#include "shaderlab/characters.h"
#include "shaderlab/tree.h"

namespace penumbra::shaderlab {

namespace {

// Finds the end of a block of shader code.
//
// A block ends at ENDHLSL, ENDCG or ENDGLSL as a whole identifier outside of the code's comments and strings:
// published shaders have such words in comments of programs that continue after them, and of programs that
// end with another one. Unity documents no rule for that.

constexpr Language all_languages[] = {Language::hlsl, Language::cg, Language::glsl};

// Returns the language and kind of an opening keyword (HLSLPROGRAM, CGINCLUDE, ...), case-insensitive.
struct BlockKeyword {
  Language language;
  bool is_include;
};

std::optional<BlockKeyword> block_keyword(std::string_view word) {
  for (const Language language : all_languages) {
    const std::string_view name = language_name(language);
    if (word.size() != name.size() + 7 || !same_keyword(word.substr(0, name.size()), name)) continue;
    const std::string_view rest = word.substr(name.size());
    if (same_keyword(rest, "PROGRAM")) return BlockKeyword{language, false};
    if (same_keyword(rest, "INCLUDE")) return BlockKeyword{language, true};
  }
  return std::nullopt;
}

struct BlockEnd {
  Place end;            // place of the closing keyword
  std::size_t after{};  // offset right after the closing keyword
  // The message and its location if there is no closing keyword.
  std::string problem;
  Place problem_place;
};

std::optional<Language> closing_word(std::string_view word) {
  if (word.size() < 5 || !same_keyword(word.substr(0, 3), "END")) return std::nullopt;
  for (const Language language : all_languages)
    if (same_keyword(word.substr(3), language_name(language))) return language;
  return std::nullopt;
}

std::string opening_word(const CodeBlock& block) {
  return std::string(language_name(block.language)) + (block.is_include ? "INCLUDE" : "PROGRAM");
}

std::string closing_word_of(Language language) {
  return std::string("END") + language_name(language);
}

class BlockScan {
 public:
  BlockScan(std::string_view text, const CodeBlock& block) : text_(text), block_(block), at_(block.begin) {}

  BlockEnd run() {
    while (at_.offset < text_.size() && !done_) step();
    if (!done_) result_ = unterminated();
    return result_;
  }

 private:
  bool starts(std::string_view with) const { return text_.substr(at_.offset, with.size()) == with; }

  void advance() {
    if (text_[at_.offset++] == '\n') {
      ++at_.line;
      at_.column = 1;
    } else {
      ++at_.column;
    }
  }

  void step() {
    const char c = text_[at_.offset];
    if (starts("//")) {
      comment("\n");
    } else if (starts("/*")) {
      comment("*/");
    } else if (c == '"') {
      string();
    } else if (is_identifier_character(c)) {
      word(false);
    } else {
      advance();
    }
  }

  void comment(std::string_view closer) {
    advance();
    advance();
    while (at_.offset < text_.size()) {
      if (starts(closer)) {
        for (std::size_t i = 0; i < closer.size(); ++i) advance();
        return;
      }
      if (is_identifier_character(text_[at_.offset])) {
        word(true);
      } else {
        advance();
      }
    }
  }

  void string() {
    advance();
    while (at_.offset < text_.size() && text_[at_.offset] != '"' && text_[at_.offset] != '\n') advance();
    if (at_.offset < text_.size()) advance();
  }

  void word(bool in_comment) {
    const Place begin = at_;
    while (at_.offset < text_.size() && is_identifier_character(text_[at_.offset])) advance();
    const std::string_view spelling = text_.substr(begin.offset, at_.offset - begin.offset);
    const std::optional<Language> closes = closing_word(spelling);
    if (in_comment) {
      if (closes == block_.language && commented_end_.line == 0) commented_end_ = begin;
    } else if (closes) {
      close(begin, *closes);
    } else if (block_keyword(spelling)) {
      done_ = true;
      result_.problem = "the " + opening_word(block_) + " of line " + std::to_string(block_.keyword.line) +
                        " is not closed before this " + upper(spelling) + ": write " +
                        closing_word_of(block_.language) + " first";
      result_.problem_place = begin;
    }
  }

  void close(const Place& place, Language closes) {
    done_ = true;
    if (closes == block_.language) {
      result_.end = place;
      result_.after = at_.offset;
      return;
    }
    result_.problem = closing_word_of(closes) + " does not close the " + opening_word(block_) + " of line " +
                      std::to_string(block_.keyword.line) + ": write " + closing_word_of(block_.language);
    result_.problem_place = place;
  }

  BlockEnd unterminated() const {
    BlockEnd none;
    none.problem =
        opening_word(block_) + " is not closed: no " + closing_word_of(block_.language) + " follows";
    if (commented_end_.line > 0)
      none.problem += " (the one in line " + std::to_string(commented_end_.line) + " is inside a comment)";
    none.problem_place = block_.keyword;
    return none;
  }

  std::string_view text_;
  const CodeBlock& block_;
  Place at_;
  bool done_ = false;
  Place commented_end_;
  BlockEnd result_;
};

// `block` has its language, keyword and begin.
BlockEnd find_block_end(std::string_view text, const CodeBlock& block) {
  return BlockScan(text, block).run();
}

// Returns a readable form of a character: itself, or its code.
std::string shown(char c) {
  constexpr char digits[] = "0123456789abcdef";
  if (c > ' ' && c < 0x7F) return {'\'', c, '\''};
  const auto byte = static_cast<unsigned char>(c);
  return std::string("the byte 0x") + digits[byte >> 4] + digits[byte & 15];
}

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  Lexed run() {
    while (!ended_) step();
    return std::move(lexed_);
  }

 private:
  char at(std::size_t offset) const { return offset < text_.size() ? text_[offset] : '\0'; }
  bool starts(std::string_view with) const { return text_.substr(at_, with.size()) == with; }
  Place here() const { return {line_, static_cast<int>(at_ - line_start_) + 1, at_}; }

  void advance_to(std::size_t end) {
    for (; at_ < end; ++at_) {
      if (text_[at_] != '\n') continue;
      ++line_;
      line_start_ = at_ + 1;
    }
  }

  void take(Token::Kind kind, std::size_t end) {
    lexed_.tokens.push_back({kind, text_.substr(at_, end - at_), here()});
    advance_to(end);
  }

  void break_at(const Place& place, std::string message) {
    lexed_.tokens.push_back({Token::Kind::broken, {}, place});
    lexed_.broken_message = std::move(message);
    ended_ = true;
  }

  void step() {
    const char c = at(at_);
    if (at_ >= text_.size()) {
      take(Token::Kind::end, at_);
      ended_ = true;
    } else if (is_blank(c) || c == '\n') {
      advance_to(at_ + 1);
    } else if (starts("//")) {
      advance_to(std::min(text_.find('\n', at_), text_.size()));
    } else if (starts("/*")) {
      comment();
    } else {
      token(c);
    }
  }

  void token(char c) {
    if (const std::size_t number = end_of_number(); number > at_) {
      take(Token::Kind::number, number);
    } else if (is_identifier_character(c)) {
      word();
    } else if (c == '"') {
      string();
    } else if (c == '[') {
      bracket();
    } else if (c == '#') {
      directive();
    } else if (std::string_view("{}(),=:+-*.").find(c) != std::string_view::npos) {
      take(Token::Kind::punctuation, at_ + 1);
    } else {
      break_at(here(), "ShaderLab has no use for " + shown(c) +
                           " here: shader code belongs between HLSLPROGRAM and ENDHLSL");
    }
  }

  std::size_t end_of_comment() {
    std::size_t depth = 0;
    for (std::size_t i = at_; comments_nest_ && i + 1 < text_.size(); ++i) {
      const std::string_view two = text_.substr(i, 2);
      if (two != "/*" && two != "*/") continue;
      depth = two == "/*" ? depth + 1 : depth - 1;
      if (depth == 0) return i + 2;
      ++i;
    }
    comments_nest_ = false;
    const std::size_t close = text_.find("*/", at_ + 2);
    return close == std::string_view::npos ? close : close + 2;
  }

  void comment() {
    const std::size_t end = end_of_comment();
    if (end == std::string_view::npos) {
      break_at(here(), "this comment is not closed: no */ follows");
    } else {
      advance_to(end);
    }
  }

  // Finds the end of -1.5e+3, .5, 7. with the sign; returns at_ when there is none. 2D and 1.0f are
  // identifiers: ShaderLab has no suffixes.
  std::size_t end_of_number() const {
    std::size_t i = at_;
    if (at(i) == '+' || at(i) == '-') ++i;
    const std::size_t digits = i;
    while (is_digit(at(i))) ++i;
    std::size_t count = i - digits;
    if (at(i) == '.') {
      ++i;
      while (is_digit(at(i))) ++i, ++count;
    }
    if (count == 0) return at_;
    if (at(i) == 'e' || at(i) == 'E') {
      const std::size_t exponent = i + (at(i + 1) == '+' || at(i + 1) == '-' ? 2 : 1);
      if (is_digit(at(exponent))) i = exponent;
      while (is_digit(at(i))) ++i;
    }
    return is_identifier_character(at(i)) ? at_ : i;
  }

  void word() {
    std::size_t end = at_;
    const bool numeric = is_digit(at(at_));  // a number followed by letters: 2D, 1.0f
    while (is_identifier_character(at(end)) || (numeric && at(end) == '.')) ++end;
    const std::optional<BlockKeyword> keyword = block_keyword(text_.substr(at_, end - at_));
    if (keyword) {
      block(*keyword, end);
    } else {
      take(Token::Kind::identifier, end);
    }
  }

  void block(const BlockKeyword& keyword, std::size_t end_of_keyword) {
    CodeBlock block{keyword.language, keyword.is_include, here(), {}, {}};
    const std::size_t start = at_;
    advance_to(end_of_keyword);
    block.begin = here();
    const BlockEnd end = find_block_end(text_, block);
    if (!end.problem.empty()) return break_at(end.problem_place, end.problem);
    block.end = end.end;
    advance_to(end.after);
    if (block.is_include) {
      lexed_.includes.push_back(block);
      return;
    }
    const std::string_view spelling = text_.substr(start, end_of_keyword - start);
    lexed_.tokens.push_back({Token::Kind::program, spelling, block.keyword, lexed_.programs.size()});
    lexed_.programs.push_back(block);
  }

  // A string ends on its line, but for the label of a property, which is the first after a '(': material
  // inspectors keep data of several lines in it.
  void string() {
    const bool is_label = !lexed_.tokens.empty() && lexed_.tokens.back().spelling == "(";
    const std::size_t close = text_.find_first_of(is_label ? "\"" : "\"\n", at_ + 1);
    if (close == std::string_view::npos || text_[close] == '\n') {
      break_at(here(), "this string is not closed on its line");
      return;
    }
    const Place place = here();
    lexed_.tokens.push_back({Token::Kind::string, text_.substr(at_ + 1, close - at_ - 1), place});
    advance_to(close + 1);
  }

  // Finds the ']' outside parentheses and strings; only parentheses may span lines. A quote after an
  // identifier (5" pipe) or alone on its line is a character of a label.
  std::size_t end_of_bracket() const {
    std::size_t depth = 0;
    for (std::size_t i = at_ + 1; i < text_.size(); ++i) {
      const char c = text_[i];
      if (c == '"' && !is_identifier_character(text_[i - 1])) {
        const std::size_t close = text_.find_first_of("\"\n", i + 1);
        if (close != std::string_view::npos && text_[close] == '"') i = close;
      } else if (c == '(') {
        ++depth;
      } else if (c == ')' && depth > 0) {
        --depth;
      } else if (depth == 0 && (c == ']' || c == '\n')) {
        return c == ']' ? i : std::string_view::npos;
      }
    }
    return std::string_view::npos;
  }

  void bracket() {
    const std::size_t close = end_of_bracket();
    if (close == std::string_view::npos) {
      break_at(here(), "this '[' is not closed: no ']' follows outside parentheses");
      return;
    }
    lexed_.tokens.push_back({Token::Kind::bracket, trimmed(text_.substr(at_ + 1, close - at_ - 1)), here()});
    advance_to(close + 1);
  }

  // #line, #warning and #error are allowed in ShaderLab itself; all others belong in a program.
  void directive() {
    std::size_t begin = at_ + 1;
    while (is_blank(at(begin))) ++begin;
    std::size_t end = begin;
    while (is_identifier_character(at(end))) ++end;
    const std::string name = "#" + std::string(text_.substr(begin, std::min<std::size_t>(end - begin, 40)));
    if (name != "#line" && name != "#warning" && name != "#error") {
      break_at(here(), "'" + name + "' is outside a program: move it between HLSLPROGRAM and ENDHLSL");
      return;
    }
    lexed_.warnings.push_back({here(), "'" + name + "' outside a program is not read"});
    advance_to(std::min(text_.find('\n', at_), text_.size()));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::size_t line_start_ = 0;
  bool comments_nest_ = true;
  bool ended_ = false;
  Lexed lexed_;
};

}  // namespace

Lexed lex(std::string_view text) {
  return Lexer(text).run();
}

}  // namespace penumbra::shaderlab
