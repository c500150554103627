#include "hlsl/tokens.h"

#include <algorithm>
#include <array>

namespace penumbra::hlsl {

namespace {

bool is_white_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

// The table is read for nearly every character of a text: it is twice as fast as comparisons.
constexpr std::array<bool, 256> characters_of_words = [] {
  std::array<bool, 256> table{};
  for (std::size_t c = 0; c < table.size(); ++c) table[c] = continues_identifier(static_cast<char>(c));
  return table;
}();
bool is_identifier_character(char c) {
  return characters_of_words[static_cast<unsigned char>(c)];
}

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  std::vector<Token> run() {
    constexpr std::size_t characters_of_a_token = 5;  // an estimate that seldom requires a reallocation
    tokens_.reserve(text_.size() / characters_of_a_token);
    while (at_ < text_.size()) step();
    return std::move(tokens_);
  }

 private:
  char next(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void step() {
    const char c = text_[at_];
    if (c == '\n') {
      ++at_;
      ++line_;
      line_is_empty_ = true;
    } else if (is_white_space(c)) {
      ++at_;
    } else if (c == '#' && line_is_empty_) {
      directive();
    } else {
      line_is_empty_ = false;
      token(c);
    }
  }

  void token(char c) {
    if (begins_identifier(c)) {
      take(Token::Kind::identifier, end_of_identifier(at_));
    } else if (is_digit(c) || (c == '.' && is_digit(next(1)))) {
      take(Token::Kind::number, end_of_number());
    } else if (c == '"') {
      take(Token::Kind::string, end_of_text());
    } else {
      take(Token::Kind::punctuation, at_ + 1);
    }
  }

  void take(Token::Kind kind, std::size_t end) {
    tokens_.push_back({kind, line_, text_.substr(at_, end - at_), file_});
    at_ = end;
  }

  std::size_t end_of_identifier(std::size_t at) const {
    while (at < text_.size() && is_identifier_character(text_[at])) ++at;
    return at;
  }

  // The numbers are 1, 0x1F, 1.5e-3f: a sign belongs to the number only after its exponent.
  std::size_t end_of_number() const {
    const bool hexadecimal = text_[at_] == '0' && (next(1) == 'x' || next(1) == 'X');
    std::size_t at = at_ + 1;
    for (; at < text_.size(); ++at) {
      const char before = text_[at - 1];
      const bool sign = (text_[at] == '+' || text_[at] == '-') && (before == 'e' || before == 'E');
      if (!is_identifier_character(text_[at]) && text_[at] != '.' && (!sign || hexadecimal)) break;
    }
    return at;
  }

  std::size_t end_of_text() const {
    std::size_t at = at_ + 1;
    while (at < text_.size() && text_[at] != '"' && text_[at] != '\n') at += text_[at] == '\\' ? 2 : 1;
    return std::min(text_.size(), at < text_.size() && text_[at] == '"' ? at + 1 : at);
  }

  // After #line N "file", the next line is line N.
  void directive() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = end;
    LinePlace behind{file_, line_};
    if (!take_line_directive(line, behind)) return;
    file_ = behind.file;
    line_ = behind.line - 1;  // the newline after this line counts one
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string_view file_;
  int line_ = 1;
  bool line_is_empty_ = true;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> lex(const std::string& preprocessed) {
  return Lexer(preprocessed).run();
}

}  // namespace penumbra::hlsl
