#include "programs/arithmetic.h"

#include <bit>
#include <cmath>
#include <limits>

namespace penumbra::programs {

namespace {

using Word = std::uint32_t;

float real(Word word) {
  return std::bit_cast<float>(word);
}

std::int32_t integer(Word word) {
  return static_cast<std::int32_t>(word);
}

// Floats stay where sums and products of a few of them are exact in any order.
Word exact(double result) {
  const auto rounded = static_cast<float>(result);
  if (!std::isfinite(rounded) || static_cast<double>(rounded) != result) throw Unfit("inexact");
  if (std::fabs(result) > 65536 || result * 64 != std::floor(result * 64)) throw Unfit("out of range");
  return std::bit_cast<Word>(rounded);
}

Word converted(Word word, Base from, Base to) {
  if (from == to) return word;
  if (to == Base::boolean) return (from == Base::real ? real(word) != 0 : word != 0) ? 1 : 0;
  if (to == Base::real) {
    if (from == Base::integer) return exact(integer(word));
    return exact(word);
  }
  if (from != Base::real) return word;
  const double whole = std::trunc(static_cast<double>(real(word)));
  if (to == Base::natural && whole < 0) throw Unfit("negative to uint");
  return to == Base::natural ? static_cast<Word>(whole) : static_cast<Word>(static_cast<std::int32_t>(whole));
}

int columns(const Type& type) {
  return type.columns > 0 ? type.columns : 1;
}

// The index of the component at this place of a smaller shape, of which the upper left ones are kept.
int source_index(const Type& from, const Type& to, int index) {
  if (from.is_scalar()) return 0;
  if (from.components() == to.components() || !from.is_matrix()) return index;
  return index / columns(to) * columns(from) + index % columns(to);
}

// The language says nothing of a divisor 0 or a shift beyond 31, and INT_MIN / -1 does not fit.
Word divided(const std::string& op, Word a, Word b, Base base) {
  if (b == 0 || (base == Base::integer && b == ~Word{0})) throw Unfit("division");
  if (base == Base::natural) return op == "/" ? a / b : a % b;
  return static_cast<Word>(op == "/" ? integer(a) / integer(b) : integer(a) % integer(b));
}

Word shifted(const std::string& op, Word a, Word b, Base base) {
  if (b > 31) throw Unfit("shift");
  if (op == "<<") return a << b;
  return base == Base::natural ? a >> b : static_cast<Word>(integer(a) >> b);
}

Word whole_arithmetic(const std::string& op, Word a, Word b, Base base) {
  switch (op[0]) {
    case '+':
      return a + b;
    case '-':
      return a - b;
    case '*':
      return a * b;
    case '&':
      return a & b;
    case '|':
      return a | b;
    case '^':
      return a ^ b;
    case '<':
    case '>':
      return shifted(op, a, b, base);
    default:
      return divided(op, a, b, base);
  }
}

Word real_arithmetic(const std::string& op, float a, float b) {
  const double x = a;
  const double y = b;
  switch (op[0]) {
    case '+':
      return exact(x + y);
    case '-':
      return exact(x - y);
    case '*':
      return exact(x * y);
    default:
      break;
  }
  if (b == 0) throw Unfit("division");
  if (op == "%") return exact(std::fmod(x, y));
  return std::bit_cast<Word>(a / b);  // the quotient is rounded, and used for what is only stored
}

template <typename T>
bool compared(const std::string& op, T a, T b) {
  if (op == "<") return a < b;
  if (op == ">") return a > b;
  if (op == "<=") return a <= b;
  if (op == ">=") return a >= b;
  return (op == "==") == (a == b);
}

bool is_comparison(const std::string& op) {
  return op == "<" || op == ">" || op == "<=" || op == ">=" || op == "==" || op == "!=";
}

Word compared_words(const std::string& op, Word a, Word b, Base base) {
  if (base == Base::real) return compared(op, real(a), real(b)) ? 1 : 0;
  if (base == Base::integer) return compared(op, integer(a), integer(b)) ? 1 : 0;
  return compared(op, a, b) ? 1 : 0;
}

}  // namespace

Value convert(const Value& value, const Type& to) {
  Value result{to, std::vector<Word>(to.components())};
  for (int i = 0; i < to.components(); ++i)
    result.words[i] = converted(value.words.at(source_index(value.type, to, i)), value.type.base, to.base);
  return result;
}

Type common_type(const Type& a, const Type& b) {
  Type type = a.is_scalar() ? b : a;
  type.base = std::max(a.base, b.base);
  if (a.is_scalar() || b.is_scalar()) return type;
  type.rows = std::min(a.rows, b.rows);
  type.columns = std::min(a.columns, b.columns);
  return type;
}

Value unary(const std::string& op, const Value& value) {
  Value result = value;
  if (op == "!") {
    result = convert(value, value.type.of_base(Base::boolean));
    for (Word& word : result.words) word = 1 - word;
    return result;
  }
  if (value.type.base == Base::boolean) result = convert(value, value.type.of_base(Base::integer));
  for (Word& word : result.words) {
    if (op == "~") {
      word = ~word;
    } else {
      word = value.type.base == Base::real ? std::bit_cast<Word>(-real(word)) : Word{0} - word;
    }
  }
  return result;
}

Value binary(const std::string& op, const Value& a, const Value& b) {
  Type type = common_type(a.type, b.type);
  const bool logical = op == "&&" || op == "||";
  if (logical) type.base = Base::boolean;
  if (!logical && type.base == Base::boolean && op != "==" && op != "!=") type.base = Base::integer;
  const Value left = convert(a, type);
  const Value right = convert(b, type);
  Value result{type, std::vector<Word>(type.components())};
  if (is_comparison(op)) result.type.base = Base::boolean;
  for (std::size_t i = 0; i < result.words.size(); ++i) {
    const Word x = left.words[i];
    const Word y = right.words[i];
    if (logical) {
      result.words[i] = op == "&&" ? x & y : x | y;
    } else if (is_comparison(op)) {
      result.words[i] = compared_words(op, x, y, type.base);
    } else {
      result.words[i] = type.base == Base::real ? real_arithmetic(op, real(x), real(y))
                                                : whole_arithmetic(op, x, y, type.base);
    }
  }
  return result;
}

Value choose(const Value& condition, const Value& yes, const Value& no) {
  Type type = common_type(yes.type, no.type);
  if (!condition.type.is_scalar()) type = common_type(type, condition.type.of_base(type.base));
  const Value a = convert(yes, type);
  const Value b = convert(no, type);
  const Value c = convert(condition, type.of_base(Base::boolean));
  Value result = b;
  for (std::size_t i = 0; i < result.words.size(); ++i)
    if (c.words[i] != 0) result.words[i] = a.words[i];
  return result;
}

}  // namespace penumbra::programs
