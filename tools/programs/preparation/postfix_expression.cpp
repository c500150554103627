#include "preparation/postfix_expression.h"

#include "hlsl/name_set.h"

namespace penumbra::preparation {

namespace {

// Keywords after which a new expression begins.
bool is_keyword(std::string_view word) {
  static constexpr hlsl::NameSet keywords("return", "else", "do", "case", "if", "while", "for", "switch");
  return keywords.contains(word);
}

bool is_name(const TokenText& text, std::size_t at) {
  return text.is_identifier(at) && !is_keyword(text.word(at));
}

// Returns whether the token is one of these characters, none of which begins an identifier, a number or a
// string.
bool is_mark(const TokenText& text, std::size_t at, std::string_view marks) {
  return std::find(marks.begin(), marks.end(), text.lead(at)) != marks.end();
}

// Returns whether two characters have no white space between them, as in "+=" and "==".
bool together(const TokenText& text, std::size_t left) {
  return left + 1 < text.size() && text.word(left).data() + 1 == text.word(left + 1).data();
}

}  // namespace

std::size_t postfix_begin(const TokenText& text, std::size_t last) {
  std::size_t at = last;
  while (at < text.size()) {
    while (text.is_any(at, ")", "]")) {  // f(x)[i]: the groups, then what they follow
      const std::size_t open = text.matching_bracket(at);
      if (open == npos) return npos;
      const bool group_of_its_own = open == 0 || !(is_name(text, open - 1) || is_mark(text, open - 1, ")]"));
      if (group_of_its_own) {
        if (text.is(open, "[")) return npos;
        at = open;
        break;
      }
      at = open - 1;
    }
    const bool begins_here = text.is(at, "(");
    if (!begins_here && !is_name(text, at)) return npos;
    if (at >= 2 && !begins_here && text.is(at - 1, ".")) {
      at -= 2;
    } else if (at >= 3 && !begins_here && text.is(at - 1, ":") && text.is(at - 2, ":")) {
      at -= 3;
    } else {
      return at;
    }
  }
  return npos;
}

std::size_t postfix_end(const TokenText& text, std::size_t first) {
  std::size_t at = first + 1;
  while (at < text.size()) {
    if (text.is(at, ".") && text.is_identifier(at + 1)) {
      at += 2;
    } else if ((text.is_any(at, "[", "(")) && text.matching_bracket(at) != npos) {
      at = text.matching_bracket(at) + 1;
    } else {
      break;
    }
  }
  return at;
}

std::size_t expression_end(const TokenText& text, std::size_t first) {
  for (std::size_t at = first; at < text.size(); ++at) {
    if (text.is(at, ";") || is_mark(text, at, ")]}")) return at;
    if (is_mark(text, at, "([{")) {
      if (text.matching_bracket(at) == npos) return npos;
      at = text.matching_bracket(at);
    }
  }
  return npos;
}

bool begins_statement(const TokenText& text, std::size_t at) {
  if (at == 0) return false;
  const std::size_t before = at - 1;
  if (is_mark(text, before, ";{}") || text.is_any(before, "else", "do")) return true;
  if (text.is(before, ":")) {  // case 1:  default:
    for (std::size_t back = before; back-- > 0 && before - back < 16;) {
      if (text.is_any(back, "case", "default")) return true;
      if (is_mark(text, back, ";{}?")) return false;
    }
    return false;
  }
  if (!text.is(before, ")")) return false;
  const std::size_t open = text.matching_bracket(before);
  if (open == npos || open == 0) return false;
  return text.is_any(open - 1, "if", "for", "while");
}

std::size_t assignment_length(const TokenText& text, std::size_t at) {
  if (text.is(at, "=")) return text.is(at + 1, "=") && together(text, at) ? 0 : 1;
  if (is_mark(text, at, "+-*/%&|^") && text.is(at + 1, "=") && together(text, at)) return 2;
  const bool shift = is_mark(text, at, "<>") && at + 2 < text.size() && text.word(at) == text.word(at + 1) &&
                     text.is(at + 2, "=") && together(text, at) && together(text, at + 1);
  return shift ? 3 : 0;
}

bool may_be_repeated(const TokenText& text, std::size_t first, std::size_t end) {
  for (std::size_t at = first; at < end; ++at) {
    const bool call = text.is(at, "(") && at > first && text.is_identifier(at - 1);
    const bool step =
        (text.is(at, "+") && text.is(at + 1, "+")) || (text.is(at, "-") && text.is(at + 1, "-"));
    if (call || step || assignment_length(text, at) != 0) return false;
  }
  return true;
}

std::vector<ListElement> list_elements(const TokenText& text, std::size_t open) {
  std::vector<ListElement> elements;
  const std::size_t close = text.matching_bracket(open);
  std::size_t first = open + 1;
  for (std::size_t at = first; at <= close; ++at) {
    if (at == close || text.is(at, ",")) {
      if (at > first) elements.push_back({first, at});
      first = at + 1;
    } else if (text.matching_bracket(at) != npos && text.matching_bracket(at) > at) {
      at = text.matching_bracket(at);
    }
  }
  return elements;
}

}  // namespace penumbra::preparation
