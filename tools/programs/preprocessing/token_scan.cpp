#include "preprocessing/token_scan.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "hlsl/identifier.h"

namespace penumbra::preprocessing {

namespace {

constexpr std::string_view decimal = "0123456789";
constexpr std::string_view hexadecimal = "0123456789abcdefABCDEF";

// Longer operators come before their prefixes.
constexpr std::array<std::string_view, 47> marks{
    "<<=", ">>=", "++", "+=", "--", "-=", "*=", "%=", "^^", "^=", "==", "!=", "||", "|=", "&&", "&=",
    "<<",  "<=",  ">>", ">=", "/=", "::", "~",  "(",  ")",  ",",  "?",  ";",  "[",  "]",  "{",  "}",
    "#",   "+",   "-",  "*",  "%",  "^",  "=",  "!",  "|",  "&",  "<",  ">",  ".",  "/",  ":"};

using hlsl::begins_identifier;
using hlsl::is_digit;

bool continues_utf8(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace

std::string message_for_bad(std::string_view spelling) {
  if (spelling.front() == '"') return "this text has no closing '\"' on its line";
  if (spelling.front() == '\0') return "a NUL byte: save this file as text in UTF-8; UTF-16 is not read";
  if (spelling == "\\") return "'\\' may only end a line";
  const auto lead = static_cast<unsigned char>(spelling.front());
  const std::size_t length = lead >= 0xF0U ? 4 : lead >= 0xE0U ? 3 : lead >= 0xC2U ? 2 : 1;
  if (lead < 0x80U || (length > 1 && spelling.size() == length))
    return "unexpected token '" + std::string(spelling) + "'";
  char byte[48];
  std::snprintf(byte, sizeof byte, "unexpected byte 0x%02X; is this file UTF-8?",
                static_cast<unsigned>(lead));
  return byte;
}

void TokenScan::newline() {
  ++line_;
  line_begin_ = at_;
}

bool TokenScan::skip_joins() {
  bool any = false;
  for (; peek() == '\\' && peek(1) == '\n'; any = true) {
    at_ += 2;
    newline();
  }
  return any;
}

// Returns true if there was white space or a comment; a line comment leaves the newline.
bool TokenScan::skip_gap() {
  bool any = false;
  for (; at_ < text_.size(); any = true) {
    if (hlsl::is_blank(peek()) || peek() == '\r' || peek() == '\f' || peek() == '\v') {
      ++at_;
    } else if (peek() == '/' && peek(1) == '/') {
      line_comment();
    } else if (peek() == '/' && peek(1) == '*') {
      block_comment();
    } else if (!skip_joins()) {
      break;
    }
  }
  return any;
}

void TokenScan::line_comment() {
  while (at_ < text_.size() && peek() != '\n')
    if (!skip_joins()) ++at_;
}

void TokenScan::block_comment() {
  const std::size_t close = text_.find("*/", at_ + 2);
  if (close == std::string_view::npos) open_comment_ = here();
  const std::size_t end = close == std::string_view::npos ? text_.size() : close + 2;
  while (at_ < end)
    if (text_[at_++] == '\n') newline();
}

Token TokenScan::next() {
  Token token;
  token.space = skip_gap();
  place_ = here();
  if (at_ >= text_.size()) return token;
  const std::size_t begin = at_;
  const char c = peek();
  if (c == '\n') {
    ++at_;
    newline();
    token.kind = Kind::newline;
    return token;
  }
  if (begins_identifier(c)) {
    while (hlsl::continues_identifier(peek())) ++at_;
    token.kind = Kind::identifier;
  } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
    token.kind = number();
  } else if (c == '"') {
    token.kind = string();
  } else {
    token.kind = punctuation();
  }
  token.spelling = spellings_.number(text_.substr(begin, at_ - begin));
  return token;
}

void TokenScan::digits(std::string_view allowed) {
  at_ = std::min(text_.find_first_not_of(allowed, at_), text_.size());
}

Kind TokenScan::number() {
  const bool based = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
  if (based) at_ += 2;
  digits(based ? hexadecimal : decimal);
  const auto is_any = [this](std::string_view letters) {
    return peek() != '\0' && letters.find(peek()) != std::string_view::npos;
  };
  if (!based && is_any(".eEfFhH")) {
    if (peek() == '.') {
      ++at_;
      digits(decimal);
    }
    if (is_any("eE")) {
      ++at_;
      if (is_any("+-")) ++at_;
      digits(decimal);
    }
    if (is_any("lLhHfF")) ++at_;
    return Kind::number;
  }
  while (is_any("uUlL")) ++at_;
  return Kind::integer;
}

Kind TokenScan::string() {
  for (++at_; at_ < text_.size() && peek() != '"' && peek() != '\n';) {
    if (skip_joins()) continue;
    at_ += peek() == '\\' && peek(1) != '\0' ? 2 : 1;
  }
  if (peek() != '"') return Kind::bad;
  ++at_;
  return Kind::string;
}

Kind TokenScan::punctuation() {
  const auto mark = std::find_if(marks.begin(), marks.end(), [&](std::string_view each) {
    return text_.compare(at_, each.size(), each) == 0;
  });
  if (mark != marks.end()) {
    at_ += mark->size();
    return Kind::punctuation;
  }
  for (++at_; at_ < text_.size() && continues_utf8(peek());) ++at_;
  return Kind::bad;
}

}  // namespace penumbra::preprocessing
