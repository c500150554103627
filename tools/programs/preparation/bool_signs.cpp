// Unary minus of a bool, `-(a > b)` and `-flag`, which is 0 or -1, because the bool is promoted to int
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-operators, unary operators); glslang
// reports "Expected expression". It becomes `(-1 * (a > b))`.
//
// An operand is recognised as a bool by a comparison, && or || within its parentheses, by a !, and by the
// type of a variable, member or function (value_types.h).

#include "preparation/passes.h"

#include "hlsl/name_set.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

class BoolSigns {
 public:
  explicit BoolSigns(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (std::size_t at = 1; at + 1 < text_.size(); ++at) {
      if (!is_sign(at)) continue;
      const std::size_t end = operand_end(at + 1);
      if (end == npos || !is_bool(at + 1, end)) continue;
      text_.replace(at, 1, "(-1 *");
      text_.insert(end, ")");
    }
    text_.apply();
  }

 private:
  // Returns whether it is a '-' with no operand before it, and no part of --, -= or ->.
  bool is_sign(std::size_t at) const {
    if (!text_.is(at, "-") || text_.is(at + 1, "-") || text_.is(at - 1, "-")) return false;
    if (text_.is_any(at - 1, ")", "]")) return false;
    if (text_.is_number(at - 1)) return false;
    return !text_.is_identifier(at - 1) || text_.is_any(at - 1, "return", "case");
  }

  std::size_t operand_end(std::size_t first) const {
    while (text_.is(first, "!")) ++first;
    if (text_.is(first, "(") && text_.matching_bracket(first) != npos) {
      const std::size_t close = text_.matching_bracket(first);
      const bool cast = close == first + 2 && text_.is_identifier(close + 1);
      return cast ? npos : postfix_end(text_, close);
    }
    return text_.is_identifier(first) ? postfix_end(text_, first) : npos;
  }

  bool is_bool(std::size_t first, std::size_t end) const {
    if (text_.is(first, "!")) return true;
    if (end == first + 1 && text_.is_any(first, "true", "false")) return true;
    if (text_.is(first, "(") && text_.matching_bracket(first) == end - 1)
      return holds_bool(first + 1, end - 1);
    if (is_bool_type(text_.word(first))) return true;  // bool2(a, b).y
    const ValueType& type = types_.at(end - 1);
    return types_.begin(end - 1) == first && type.dimensions == 0 && is_bool_type(type.name);
  }

  static bool is_bool_type(std::string_view type) {
    static constexpr hlsl::NameSet bools("bool", "bool1", "bool2", "bool3", "bool4");
    return bools.contains(type);
  }

  // Returns whether the operator with the lowest precedence between the parentheses returns a bool.
  bool holds_bool(std::size_t first, std::size_t end) const {
    bool compares = false;
    for (std::size_t at = first; at < end; ++at) {
      if (text_.matching_bracket(at) != npos && text_.matching_bracket(at) > at) {
        at = text_.matching_bracket(at);
        continue;
      }
      const bool twice = text_.is(at + 1, text_.word(at));
      const char mark = text_.lead(at);
      if (mark == '?' || mark == ',') return false;
      if (mark == '^' || ((mark == '&' || mark == '|') && !twice)) return false;
      if ((mark == '<' || mark == '>') && twice) {
        ++at;  // a shift
      } else if (mark == '<' || mark == '>' || mark == '=' || mark == '&' || mark == '|') {
        const bool assigns = mark == '=' && !text_.is(at + 1, "=") && !text_.is(at - 1, "!");
        if (assigns) return false;
        compares = true;
        if (twice || text_.is(at + 1, "=")) ++at;
      }
    }
    if (compares) return true;
    const std::size_t operand = operand_end(first);
    return operand == end && is_bool(first, end);
  }

  TokenText& text_;
  const ValueTypes& types_;
};

}  // namespace

void multiply_bool_signs(TokenText& text) {
  BoolSigns(text).run();
}

}  // namespace penumbra::preparation
