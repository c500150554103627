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
constexpr int deepest_expression = 1000;

// A number of 32 bits. As in C, an operation is unsigned where one of its operands is.
struct Value {
  std::uint32_t bits = 0;
  bool is_unsigned = false;

  std::int32_t number() const { return static_cast<std::int32_t>(bits); }
};

Value truth(bool value) {
  return {value ? 1U : 0U, false};
}

bool is_less(Value a, Value b, bool is_unsigned) {
  return is_unsigned ? a.bits < b.bits : a.number() < b.number();
}

// The divisor is not 0.
Value divided(Spelling operation, Value a, Value b, bool is_unsigned) {
  const bool quotient = operation == known::divide;
  if (is_unsigned) return {quotient ? a.bits / b.bits : a.bits % b.bits, true};
  if (b.number() == -1) return {quotient ? 0U - a.bits : 0U, false};
  return {static_cast<std::uint32_t>(quotient ? a.number() / b.number() : a.number() % b.number()), false};
}

Value shifted(Spelling operation, Value a, Value b) {
  if (b.bits > 31) throw Problem("in this condition: a shift by less than 0 or more than 31");
  if (operation == known::shift_left) return {a.bits << b.bits, a.is_unsigned};
  return {a.is_unsigned ? a.bits >> b.bits : static_cast<std::uint32_t>(a.number() >> b.bits), a.is_unsigned};
}

Value applied(Spelling operation, Value a, Value b) {
  const bool is_unsigned = a.is_unsigned || b.is_unsigned;
  switch (operation) {
    case known::logical_or:
      return truth(a.bits != 0 || b.bits != 0);
    case known::logical_and:
      return truth(a.bits != 0 && b.bits != 0);
    case known::bit_or:
      return {a.bits | b.bits, is_unsigned};
    case known::bit_xor:
      return {a.bits ^ b.bits, is_unsigned};
    case known::bit_and:
      return {a.bits & b.bits, is_unsigned};
    case known::equal:
      return truth(a.bits == b.bits);
    case known::unequal:
      return truth(a.bits != b.bits);
    case known::greater:
      return truth(is_less(b, a, is_unsigned));
    case known::at_least:
      return truth(!is_less(a, b, is_unsigned));
    case known::less:
      return truth(is_less(a, b, is_unsigned));
    case known::at_most:
      return truth(!is_less(b, a, is_unsigned));
    case known::plus:
      return {a.bits + b.bits, is_unsigned};
    case known::minus:
      return {a.bits - b.bits, is_unsigned};
    case known::times:
      return {a.bits * b.bits, is_unsigned};
    case known::divide:
    case known::remainder:
      return divided(operation, a, b, is_unsigned);
    default:
      return shifted(operation, a, b);
  }
}

// Identifiers that are no macros have the value 0.
class Evaluation {
 public:
  Evaluation(const std::vector<Token>& tokens, const Spellings& spellings)
      : tokens_(tokens), spellings_(spellings) {}

  bool run() {
    const Value value = choice(true);
    if (at_ < tokens_.size())
      throw Problem("the condition ends before its line does, at '" + spellings_.text(tokens_[at_].spelling) +
                    "'");
    return value.bits != 0;
  }

 private:
  bool take(Spelling punctuation) {
    const bool is_there = at_ < tokens_.size() && tokens_[at_].is(punctuation);
    if (is_there) ++at_;
    return is_there;
  }

  // `counts` is false where the value is not used: dividing by zero is no error there.
  Value choice(bool counts) {
    if (++depth_ > deepest_expression) throw Problem("in this condition: brackets nested too deeply");
    const Value condition = expression(0, counts);
    Value value = condition;
    if (take(known::question)) {
      const Value first = choice(counts && condition.bits != 0);
      if (!take(known::colon)) throw Problem("in this condition: '?' without ':'");
      const Value second = choice(counts && condition.bits == 0);
      value = condition.bits != 0 ? first : second;
      value.is_unsigned = first.is_unsigned || second.is_unsigned;
    }
    --depth_;
    return value;
  }

  Value expression(int precedence, bool counts) {
    Value value = operand(counts);
    while (at_ < tokens_.size()) {
      const int here = precedence_of(tokens_[at_]);
      if (here <= precedence) break;
      const Spelling operation = tokens_[at_++].spelling;
      const bool decided = (operation == known::logical_or && value.bits != 0) ||
                           (operation == known::logical_and && value.bits == 0);
      const Value other = expression(here, counts && !decided);
      if ((operation == known::divide || operation == known::remainder) && other.bits == 0) {
        if (counts) throw Problem("in this condition: division by 0");
        value = {};
      } else {
        value = applied(operation, value, other);
      }
    }
    return value;
  }

  Value operand(bool counts) {
    if (at_ == tokens_.size()) throw Problem("this condition has no value");
    const Token token = tokens_[at_++];
    if (token.kind == Kind::identifier) return {};
    if (token.kind == Kind::integer) return value_of(spellings_.text(token.spelling));
    if (++depth_ > deepest_expression) throw Problem("in this condition: operators nested too deeply");
    Value value;
    if (token.is(known::open)) {
      value = choice(counts);
      if (!take(known::close)) throw Problem("in this condition: '(' is never closed");
    } else if (token.is(known::plus)) {
      value = expression(of_unary, counts);
    } else if (token.is(known::minus)) {
      value = expression(of_unary, counts);
      value.bits = 0U - value.bits;
    } else if (token.is(known::complement)) {
      value = expression(of_unary, counts);
      value.bits = ~value.bits;
    } else if (token.is(known::negate)) {
      value = truth(expression(of_unary, counts).bits == 0);
    } else {
      throw Problem("this condition has no value: unexpected '" + spellings_.text(token.spelling) + "'");
    }
    --depth_;
    return value;
  }

  // A number is unsigned if it says so, or if it is too large for an int.
  static Value value_of(const std::string& number) {
    char* end = nullptr;
    const std::uint64_t value = std::strtoull(number.c_str(), &end, 0);
    const std::string_view suffix(end);
    if (suffix.find_first_not_of("uUlL") != std::string_view::npos)
      throw Problem("in this condition: '" + number + "' is not an integer");
    const bool says_so = suffix.find_first_of("uU") != std::string_view::npos;
    return {static_cast<std::uint32_t>(value), says_so || value > std::numeric_limits<std::int32_t>::max()};
  }

  const std::vector<Token>& tokens_;
  const Spellings& spellings_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

bool holds(const Token* first, const Token* last, Expansion& expansion, const Spellings& spellings) {
  const std::vector<Token> tokens = expansion.expanded(first, last, true);
  return Evaluation(tokens, spellings).run();
}

}  // namespace penumbra::preprocessing
