#include <algorithm>
#include <set>
#include <string_view>

#include "preparation/declarators.h"
#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

bool is_integer(std::string_view number) {
  const bool hexadecimal = number.starts_with("0x") || number.starts_with("0X");
  if (hexadecimal) number.remove_prefix(2);
  while (!number.empty() && std::string_view("uUlL").find(number.back()) != std::string_view::npos)
    number.remove_suffix(1);
  return !number.empty() && std::all_of(number.begin(), number.end(), [&](char c) {
    return (c >= '0' && c <= '9') || (hexadecimal && ((c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F')));
  });
}

bool is_zero_literal(std::string_view number) {
  return is_integer(number) && number.find_first_of("123456789abcdefABCDEF") == std::string_view::npos;
}

class ConstantDivisions {
 public:
  explicit ConstantDivisions(TokenText& text) : text_(text) {}

  void run() {
    for (std::size_t at = 1; at + 1 < text_.size(); ++at)
      if (text_.is(at, "/") || text_.is(at, "%")) divide(at);
  }

 private:
  void divide(std::size_t at) {
    const std::size_t divisor = at + 1;
    if (text_[divisor].kind == hlsl::Token::Kind::number) {
      if (!is_zero_literal(text_[divisor].spelling)) return;
    } else if (!text_.is_identifier(divisor) || constants().zeros.count(text_[divisor].spelling) == 0) {
      return;
    }
    const bool is_first = at < 2 || !(text_.is(at - 2, ".") || text_.is(at - 2, "-"));
    const bool by_number =
        text_[at - 1].kind == hlsl::Token::Kind::number && is_integer(text_[at - 1].spelling);
    const bool by_name =
        text_.is_identifier(at - 1) && is_first && constants().all.count(text_[at - 1].spelling) != 0;
    if ((by_number || by_name) && !text_.is(divisor + 1, ".") && !is_conditional(at))
      text_.note(at, hlsl::Severity::error, "an integer is divided by zero");
  }

  // It is unknown whether a compiler reports a division in a branch that is not taken, so these are skipped.
  bool is_conditional(std::size_t at) const {
    for (; at > 0 && !text_.is(at, ";") && !text_.is(at, "{") && !text_.is(at, "}"); --at)
      if (text_.is(at, "?") || text_.is(at, "if")) return true;
    return false;
  }

  struct Constants {
    std::set<std::string_view> all;    // integers at file scope, static and const, of one literal
    std::set<std::string_view> zeros;  // those that are zero
  };

  const Constants& constants() {
    if (read_) return constants_;
    read_ = true;
    for (const hlsl::Declaration& declaration : text_.declarations()) {
      if (declaration.kind != hlsl::Declaration::Kind::variable) continue;
      for (const Declarator& variable : declarators(text_, declaration.first, declaration.last)) {
        const bool is_int = variable.type == "int" || variable.type == "uint";
        if (!variable.is_static || !variable.is_const || !is_int || variable.dimension_count != 0 ||
            variable.initialiser == npos || variable.initialiser + 1 != variable.end)
          continue;
        const std::string_view value = text_[variable.initialiser].spelling;
        if (!is_integer(value)) continue;
        constants_.all.insert(text_[variable.name].spelling);
        if (is_zero_literal(value)) constants_.zeros.insert(text_[variable.name].spelling);
      }
    }
    return constants_;
  }

  TokenText& text_;
  bool read_ = false;
  Constants constants_;
};

}  // namespace

void check_constant_divisions(TokenText& text) {
  ConstantDivisions(text).run();
}

}  // namespace penumbra::preparation
