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
  if (a == std::numeric_limits<std::int32_t>::min() && b == -1) return 0;
  return operation == known::divide ? a / b : a % b;
}

std::int32_t shifted(Spelling operation, std::int32_t a, std::int32_t b) {
  if (b < 0 || b > 31) throw Problem("in this condition: a shift by less than 0 or more than 31");
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

// Identifiers that are no macros have the value 0.
class Evaluation {
 public:
  Evaluation(const std::vector<Token>& tokens, const Spellings& spellings)
      : tokens_(tokens), spellings_(spellings) {}

  std::int32_t run() {
    const std::int32_t value = choice(true);
    if (at_ < tokens_.size())
      throw Problem("the condition ends before its line does, at '" + spellings_.text(tokens_[at_].spelling) +
                    "'");
    return value;
  }

 private:
  bool take(Spelling punctuation) {
    const bool is_there = at_ < tokens_.size() && tokens_[at_].is(punctuation);
    if (is_there) ++at_;
    return is_there;
  }

  // `counts` is false where the value is not used: dividing by zero is no error there.
  std::int32_t choice(bool counts) {
    if (++depth_ > deepest_expression) throw Problem("in this condition: brackets nested too deeply");
    const std::int32_t condition = expression(0, counts);
    std::int32_t value = condition;
    if (take(known::question)) {
      const std::int32_t first = choice(counts && condition != 0);
      if (!take(known::colon)) throw Problem("in this condition: '?' without ':'");
      const std::int32_t second = choice(counts && condition == 0);
      value = condition != 0 ? first : second;
    }
    --depth_;
    return value;
  }

  std::int32_t expression(int precedence, bool counts) {
    std::int32_t value = operand(counts);
    while (at_ < tokens_.size()) {
      const int here = precedence_of(tokens_[at_]);
      if (here <= precedence) break;
      const Spelling operation = tokens_[at_++].spelling;
      const bool decided =
          (operation == known::logical_or && value != 0) || (operation == known::logical_and && value == 0);
      const std::int32_t other = expression(here, counts && !decided);
      if ((operation == known::divide || operation == known::remainder) && other == 0) {
        if (counts) throw Problem("in this condition: division by 0");
        value = 0;
      } else {
        value = applied(operation, value, other);
      }
    }
    return value;
  }

  std::int32_t operand(bool counts) {
    if (at_ == tokens_.size()) throw Problem("this condition has no value");
    const Token token = tokens_[at_++];
    if (token.kind == Kind::identifier) return 0;
    if (token.kind == Kind::integer) return value_of(spellings_.text(token.spelling));
    if (++depth_ > deepest_expression) throw Problem("in this condition: operators nested too deeply");
    std::int32_t value = 0;
    if (token.is(known::open)) {
      value = choice(counts);
      if (!take(known::close)) throw Problem("in this condition: '(' is never closed");
    } else if (token.is(known::plus)) {
      value = expression(of_unary, counts);
    } else if (token.is(known::minus)) {
      value = wrapped(-std::int64_t{expression(of_unary, counts)});
    } else if (token.is(known::complement)) {
      value = ~expression(of_unary, counts);
    } else if (token.is(known::negate)) {
      value = expression(of_unary, counts) == 0;
    } else {
      throw Problem("this condition has no value: unexpected '" + spellings_.text(token.spelling) + "'");
    }
    --depth_;
    return value;
  }

  static std::int32_t value_of(const std::string& number) {
    char* end = nullptr;
    const std::uint64_t value = std::strtoull(number.c_str(), &end, 0);
    if (std::string_view("uUlL").find(*end) == std::string_view::npos && *end != '\0')
      throw Problem("in this condition: '" + number + "' is not an integer");
    return wrapped(static_cast<std::int64_t>(value));
  }

  const std::vector<Token>& tokens_;
  const Spellings& spellings_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

bool holds(const Token* first, const Token* last, Expansion& expansion, const Spellings& spellings) {
  const std::vector<Token> tokens = expansion.expanded(first, last, true);
  return Evaluation(tokens, spellings).run() != 0;
}

}  // namespace penumbra::preprocessing
