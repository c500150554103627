#include "preprocessing/token_scan.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <utility>

#include "hlsl/identifier.h"

namespace penumbra::preprocessing {

namespace {

constexpr std::size_t longest_token = 1000;  // glslang's limit is 1024
constexpr std::string_view decimal = "0123456789";
constexpr std::string_view octal = "01234567";
constexpr std::string_view hexadecimal = "0123456789abcdefABCDEF";

// Longer operators come before their prefixes.
constexpr std::array<std::string_view, 48> marks{
    "<<=", ">>=", "++", "+=", "--", "-=", "*=", "%=", "^^", "^=", "==", "!=", "||", "|=", "&&", "&=",
    "<<",  "<=",  ">>", ">=", "/=", "::", "~",  "(",  ")",  ",",  "?",  ";",  "[",  "]",  "{",  "}",
    "#",   "+",   "-",  "*",  "%",  "^",  "=",  "!",  "|",  "&",  "<",  ">",  ".",  "/",  ":",  "\\"};

using hlsl::begins_identifier;
using hlsl::is_digit;

// The values of these macros are not known here. VULKAN and GL_EXT_multiview, which glslang defines as well,
// are no macros in HLSL.
bool is_predefined(std::string_view name) {
  return name == "__LINE__" || name == "__FILE__" || name == "__VERSION__";
}

bool stands_alone(std::string_view mark) {
  return mark.size() == 1 && std::string_view("~(),?;[]{}#").find(mark) != std::string_view::npos;
}

}  // namespace

bool is_left_to_glslang(std::string_view name) {
  return is_predefined(name) || name.size() > longest_token;
}

bool TokenScan::take_whole_float() {
  return std::exchange(whole_float_, false);
}

void TokenScan::newline() {
  ++line_;
  line_begin_ = at_;
}

bool TokenScan::skip_joins() {
  bool any = false;
  for (; at_join(); any = true) {
    at_ += 2;
    newline();
  }
  return any;
}

// Returns true if there was white space or a comment; a line comment leaves the newline.
bool TokenScan::skip_gap() {
  bool any = false;
  while (at_ < text_.size()) {
    if (peek() == ' ' || peek() == '\t') {
      ++at_;
    } else if (peek() == '/' && peek(1) == '/') {
      line_comment();
    } else if (peek() == '/' && peek(1) == '*') {
      block_comment();
    } else {
      if (!skip_joins()) break;
      continue;
    }
    any = true;
  }
  return any;
}

void TokenScan::line_comment() {
  while (at_ < text_.size() && peek() != '\n')
    if (!skip_joins()) ++at_;
}

void TokenScan::block_comment() {
  const std::size_t close = text_.find("*/", at_ + 2);
  unusual_ = unusual_ || close == std::string_view::npos;
  const std::size_t end = close == std::string_view::npos ? text_.size() : close + 2;
  for (; at_ < end; ++at_) {
    if (peek() != '\n') continue;
    unusual_ = unusual_ || text_[at_ - 1] == '\\';  // might join '*' and '/'
    ++line_;
    line_begin_ = at_ + 1;
  }
}

Token TokenScan::next() {
  Token token;
  token.space = skip_gap();
  place_ = {line_, static_cast<int>(at_ - line_begin_) + 1, 0, false};
  if (at_ >= text_.size()) return token;
  const std::size_t begin = at_;
  const char c = peek();
  looked_ahead_ = true;
  if (c == '\n') {
    ++at_;
    newline();
    token.kind = Kind::newline;
    return token;
  }
  if (begins_identifier(c)) {
    word();
    token.kind = Kind::identifier;
  } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
    token.kind = number();
  } else if (c == '"') {
    token.kind = string();
  } else {
    token.kind = punctuation();
  }
  return finish(token, begin);
}

// Returns whether text after a joined line could still belong to the token.
bool TokenScan::goes_on(Kind kind) const {
  std::size_t at = at_;
  while (at + 1 < text_.size() && text_[at] == '\\' && text_[at + 1] == '\n') at += 2;
  const char c = at < text_.size() ? text_[at] : '\n';
  if (c == ' ' || c == '\t') return false;
  if (kind == Kind::identifier) return hlsl::continues_identifier(c) || c == '\n';
  return looked_ahead_;
}

Token TokenScan::finish(Token token, std::size_t begin) {
  const std::string_view text = text_.substr(begin, at_ - begin);
  unusual_ = unusual_ || text.size() > longest_token;
  if (token.kind == Kind::identifier && is_left_to_glslang(text)) token.kind = Kind::unusual;
  token.spelling = spellings_.number(text);
  place_.after = place_.column + static_cast<int>(text.size()) - 1;
  // This reproduces its effect when it puts back a newline or a text's last character.
  const bool newline_next = peek() == '\n';
  if (looked_ahead_ && newline_next && line_ > 1) ++place_.after;
  if (looked_ahead_ && !newline_next && at_ + 1 == text_.size()) ++place_.after;
  const bool near_end = looked_ahead_ && at_ + 1 == text_.size() && token.kind != Kind::identifier;
  if (at_ >= text_.size() || near_end) place_.after = 0;
  if (at_join()) {
    unusual_ = unusual_ || goes_on(token.kind);
    place_.joined = looked_ahead_;
    if (looked_ahead_) place_.after = 0;
  }
  return token;
}

void TokenScan::word() {
  while (hlsl::continues_identifier(peek())) ++at_;
}

void TokenScan::digits(std::string_view allowed) {
  at_ = std::min(text_.find_first_not_of(allowed, at_), text_.size());
}

Kind TokenScan::number() {
  const std::size_t begin = at_;
  if (peek() == '0' && (peek(1) == 'x' || peek(1) == 'X')) {
    at_ += 2;
    const std::size_t first = at_;
    digits(hexadecimal);
    unusual_ = unusual_ || at_ == first;
    return integer(first, 16);
  }
  const bool leading_zero = peek() == '0';
  digits(decimal);
  if (std::string_view(".eEfFhH").find(peek()) != std::string_view::npos && peek() != '\0')
    return real(peek() == '.');
  if (!leading_zero) return integer(begin, 10);
  unusual_ = unusual_ || text_.substr(begin, at_ - begin).find_first_not_of(octal) != std::string_view::npos;
  return integer(begin, 8);
}

// Reads the rest of an integer after its digits, which begin at `begin`. A number of more than 32 bits is an
// error in glslang.
Kind TokenScan::integer(std::size_t begin, int base) {
  std::uint64_t value = 0;
  const auto read = std::from_chars(text_.data() + begin, text_.data() + at_, value, base);
  unusual_ = unusual_ || read.ec != std::errc() || value > std::numeric_limits<std::uint32_t>::max();
  if (peek() == 'u' || peek() == 'U') {
    ++at_;
    if (peek() == 'l' || peek() == 'L') ++at_;
    return Kind::number;
  }
  if (peek() != 'l' && peek() != 'L') return Kind::integer;
  ++at_;
  looked_ahead_ = false;
  return Kind::integer;
}

// Reads a real number at the point, the exponent or the suffix.
Kind TokenScan::real(bool fraction) {
  bool whole = !fraction;
  if (fraction) {
    ++at_;
    unusual_ = unusual_ || peek() == '#';
    digits(decimal);
  }
  if (peek() == 'e' || peek() == 'E') {
    whole = false;
    ++at_;
    if (peek() == '+' || peek() == '-') ++at_;
    const std::size_t first = at_;
    digits(decimal);
    unusual_ = unusual_ || at_ == first;
  }
  const char suffix = peek();
  if (suffix == '\0' || std::string_view("lLhHfF").find(suffix) == std::string_view::npos)
    return Kind::number;
  ++at_;
  looked_ahead_ = false;
  whole_float_ = whole_float_ || whole;
  return Kind::number;
}

Kind TokenScan::string() {
  const std::size_t end = text_.find_first_of("\"\\\n", at_ + 1);
  const bool whole = end != std::string_view::npos && text_[end] == '"';
  unusual_ = unusual_ || !whole;
  at_ = end == std::string_view::npos ? text_.size() : end + (whole ? 1 : 0);
  looked_ahead_ = false;
  return Kind::string;
}

Kind TokenScan::punctuation() {
  const auto mark = std::find_if(marks.begin(), marks.end(), [&](std::string_view each) {
    return text_.compare(at_, each.size(), each) == 0;
  });
  if (mark == marks.end() || *mark == "\\") {
    const char c = text_[at_++];
    unusual_ = unusual_ || c == '\'' || c == '\\' || c == '\0' || c == '\r';
    return Kind::unusual;
  }
  at_ += mark->size();
  looked_ahead_ = !stands_alone(*mark) && (mark->size() == 1 || *mark == "<<" || *mark == ">>");
  return Kind::punctuation;
}

}  // namespace penumbra::preprocessing
