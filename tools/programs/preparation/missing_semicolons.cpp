#include "hlsl/name_set.h"
#include "preparation/declarators.h"
#include "preparation/declared_values.h"
#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

// glslang also accepts these as names, so a declaration may begin in the middle of a statement.
bool is_scalar_type(std::string_view word) {
  static constexpr hlsl::NameSet types("bool", "int", "uint", "dword", "half", "float", "double");
  return types.contains(word);
}

class MissingSemicolons {
 public:
  explicit MissingSemicolons(TokenText& text) : text_(text) {}

  void run() {
    for (std::size_t at = 1; at + 1 < text_.size(); ++at) {
      if (text_.is(at, "{") && is_struct(at)) check_behind_struct(text_.matching_bracket(at));
      const bool number = text_.is_number(at);
      if (!number && !text_.is_identifier(at)) continue;
      if (is_scalar_type(text_.word(at)) && text_.is_identifier(at + 1)) {
        if (ends_a_statement(at - 1))
          text_.error(at, "expected ';' before '" + text_.name(at) + " " + text_.name(at + 1) + "'");
      } else if (!begins_a_statement(at) && !goes_on(at) && (ends_a_value(at - 1) || is_second_name(at))) {
        text_.error(at, "expected ',' or ';' before '" + text_.name(at) + "'");
      }
    }
  }

 private:
  // Returns whether it is struct Name {, struct Name : Base {.
  bool is_struct(std::size_t open) const {
    for (std::size_t at = open; at > 0 && open - at < 4; --at)
      if (text_.is(at - 1, "struct")) return text_.matching_bracket(open) != npos;
    return false;
  }

  // A scalar type behind the struct's '}' would be the name of a variable; others the front end reports.
  void check_behind_struct(std::size_t close) {
    if (close + 1 >= text_.size() || !text_.is_identifier(close + 1)) return;
    if (is_scalar_type(text_.word(close + 1))) text_.error(close, "expected ';' behind this '}' of a struct");
  }

  // The front end reports the missing ';' before it.
  bool begins_a_statement(std::size_t at) const {
    static constexpr hlsl::NameSet words("return", "if", "else", "for", "while", "do", "switch", "case",
                                         "default", "break", "continue", "discard");
    return words.contains(text_.word(at));
  }

  // The text is `1.5.5`, which the front end reports as an invalid number.
  bool goes_on(std::size_t at) const { return text_.is_number(at) && text_.is_number(at - 1); }

  // Returns whether only an operator, a ',' or the end of the expression can follow this token.
  bool ends_a_value(std::size_t at) const {
    if (text_.is_number(at)) return text_.word(at).back() != '.';  // 0.xxxx
    if (text_.is_identifier(at)) return !is_modifier(text_.word(at)) && follows_an_operator(at);
    const std::size_t open = text_.matching_bracket(at);
    if (open == npos || open < 2 || (!text_.is_any(at, ")", "]"))) return false;
    return text_.is_identifier(open - 1) && !is_modifier(text_.word(open - 1)) &&
           follows_an_operator(open - 1);
  }

  // The marks `<` and `>` may belong to template arguments, ':' to a label, and after '(' and ',' a
  // declaration may follow.
  bool follows_an_operator(std::size_t at) const {
    static constexpr hlsl::NameSet others("compile", "asm", "sampler_state", "else", "do", "return");
    if (at == 0 || others.contains(text_.word(at))) return false;
    return text_.lead(at - 1) != '\0' && std::string_view("=+-*/%.&|^!~?").find(text_.lead(at - 1)) != npos;
  }

  // Returns whether it is the second of `float a b`.
  bool is_second_name(std::size_t at) const {
    return at > 1 && text_.is_identifier(at) && text_.is_identifier(at - 1) &&
           is_number_type(text_.word(at - 2)) && !is_modifier(text_.word(at - 1)) &&
           !is_modifier(text_.word(at));
  }

  // Returns whether this token can only be the last of a statement that lacks its ';'.
  bool ends_a_statement(std::size_t at) const {
    if (text_.is_number(at)) return true;
    const std::size_t open = text_.matching_bracket(at);
    if (text_.is(at, ")")) return open != npos && open > 0 && is_call(open);
    if (text_.is(at, "]"))
      return open != npos && open > 0 && (text_.is_identifier(open - 1) || text_.is(open - 1, "]"));
    return text_.is_identifier(at) && follows_a_value(at);
  }

  // Returns whether it is `name(...)`: not the parentheses of a condition, of a loop or of a definition
  // without its brace.
  bool is_call(std::size_t open) const {
    static constexpr hlsl::NameSet conditions("if", "for", "while", "switch");
    return text_.is_identifier(open - 1) && !conditions.contains(text_.word(open - 1));
  }

  // Returns whether it is a name after an operator, after `return`, or after a scalar type; an identifier
  // after another one may follow a modifier.
  bool follows_a_value(std::size_t at) const {
    static constexpr hlsl::NameSet keywords("else", "do", "return", "in", "out", "inout");
    if (at == 0 || keywords.contains(text_.word(at))) return false;
    if (text_.is(at - 1, "return") || is_scalar_type(text_.word(at - 1))) return true;
    return std::string_view("=+-*/%.:").find(text_.lead(at - 1)) != std::string_view::npos;
  }

  TokenText& text_;
};

}  // namespace

void check_semicolons(TokenText& text) {
  MissingSemicolons(text).run();
}

}  // namespace penumbra::preparation
