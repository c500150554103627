#include "preprocessing/condition.h"

#include <cstdint>
#include <cstdlib>
#include <limits>

namespace penumbra::preprocessing {

namespace {

// Returns the precedence of binary operators; 0 for other tokens.
int precedence_of(const Token& token) {
  if (token.kind != Kind::punctuation) return 0;
  switch (token.spelling) {
    case known::logical_or:
      return 1;
    case known::logical_and:
      return 2;
    case known::bit_or:
      return 3;
    case known::bit_xor:
      return 4;
    case known::bit_and:
      return 5;
    case known::equal:
    case known::unequal:
      return 6;
    case known::greater:
    case known::at_least:
    case known::less:
    case known::at_most:
      return 7;
    case known::shift_left:
    case known::shift_right:
      return 8;
    case known::plus:
    case known::minus:
      return 9;
    case known::times:
    case known::divide:
    case known::remainder:
      return 10;
    default:
      return 0;
  }
}

constexpr int of_unary = 11;
constexpr int deepest_expression = 200;

std::int32_t wrapped(std::int64_t value) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(value));
}

std::int32_t divided(Spelling operation, std::int32_t a, std::int32_t b) {
  if (b == 0) throw Unusual("division by zero");
  if (a == std::numeric_limits<std::int32_t>::min() && b == -1) return 0;
  return operation == known::divide ? a / b : a % b;
}

std::int32_t shifted(Spelling operation, std::int32_t a, std::int32_t b) {
  if (b < 0 || b > 31) throw Unusual("a shift that C++ does not define");
  return operation == known::shift_left ? wrapped(std::int64_t{a} << b) : a >> b;
}

std::int32_t applied(Spelling operation, std::int32_t a, std::int32_t b) {
  switch (operation) {
    case known::logical_or:
      return a != 0 || b != 0;
    case known::logical_and:
      return a != 0 && b != 0;
    case known::bit_or:
      return a | b;
    case known::bit_xor:
      return a ^ b;
    case known::bit_and:
      return a & b;
    case known::equal:
      return a == b;
    case known::unequal:
      return a != b;
    case known::greater:
      return a > b;
    case known::at_least:
      return a >= b;
    case known::less:
      return a < b;
    case known::at_most:
      return a <= b;
    case known::plus:
      return wrapped(std::int64_t{a} + b);
    case known::minus:
      return wrapped(std::int64_t{a} - b);
    case known::times:
      return wrapped(std::int64_t{a} * b);
    case known::divide:
    case known::remainder:
      return divided(operation, a, b);
    default:
      return shifted(operation, a, b);
  }
}

class Evaluation {
 public:
  Evaluation(Expansion& expansion, const Macros& macros, const Spellings& spellings)
      : expansion_(expansion), macros_(macros), spellings_(spellings) {}

  std::int32_t run() {
    read_ = expansion_.scan();
    const std::int32_t value = expression(0);
    if (read_.token.kind != Kind::newline) throw Unusual("tokens after a condition");
    return value;
  }

 private:
  void next() { read_ = expansion_.scan(); }

  bool is_name() const {
    return read_.token.kind == Kind::identifier && read_.token.spelling != known::word_defined;
  }

  // Expands macros until the next token is not an identifier.
  void expand() {
    while (is_name()) {
      if (!expansion_.expand(read_, true)) throw Unusual("an identifier without a value");
      next();
    }
  }

  std::int32_t expression(int precedence) {
    if (++depth_ > deepest_expression) throw Unusual("parentheses nested too deeply");
    if (is_name()) {
      expansion_.paste(read_);
      expand();
    }
    std::int32_t value = operand();
    expand();
    for (int here = precedence_of(read_.token); here > precedence; here = precedence_of(read_.token)) {
      const Spelling operation = read_.token.spelling;
      next();
      value = applied(operation, value, expression(here));
    }
    --depth_;
    return value;
  }

  std::int32_t operand() {
    const Token token = read_.token;
    if (token.kind == Kind::identifier) return defined();
    next();
    if (token.kind == Kind::integer) return value_of(token);
    if (token.is(known::open)) {
      const std::int32_t value = expression(0);
      if (!read_.token.is(known::close)) throw Unusual("an unmatched '(' in a condition");
      next();
      return value;
    }
    if (token.is(known::plus)) return expression(of_unary);
    if (token.is(known::minus)) return wrapped(-std::int64_t{expression(of_unary)});
    if (token.is(known::complement)) return ~expression(of_unary);
    if (token.is(known::negate)) return expression(of_unary) == 0;
    throw Unusual("a condition that cannot be evaluated");
  }

  std::int32_t value_of(const Token& token) const {
    return wrapped(
        static_cast<std::int64_t>(std::strtoull(spellings_.text(token.spelling).c_str(), nullptr, 0)));
  }

  std::int32_t defined() {
    next();
    const bool bracket = read_.token.is(known::open);
    if (bracket) next();
    if (read_.token.kind != Kind::identifier) throw Unusual("defined without an identifier");
    const bool value = macros_.is_defined(read_.token.spelling);
    next();
    if (bracket && !read_.token.is(known::close)) throw Unusual("an unmatched '(' after defined");
    if (bracket) next();
    return value;
  }

  Expansion& expansion_;
  const Macros& macros_;
  const Spellings& spellings_;
  Read read_;
  int depth_ = 0;
};

}  // namespace

bool holds(const Token* first, const Token* last, Expansion& expansion, const Macros& macros,
           const Spellings& spellings) {
  expansion.read_condition(first, last);
  return Evaluation(expansion, macros, spellings).run() != 0;
}

}  // namespace penumbra::preprocessing
