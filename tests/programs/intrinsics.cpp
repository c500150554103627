// The intrinsic functions of HLSL, one line for each where one suffices.
#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>

#include "programs/arithmetic.h"

namespace penumbra::programs {

namespace {

using Word = std::uint32_t;
using Words = std::vector<Word>;
using Componentwise = std::function<Word(const Words&, Base)>;

double real(Word word) {
  return std::bit_cast<float>(word);
}

std::int32_t integer(Word word) {
  return static_cast<std::int32_t>(word);
}

Word bits(double value) {
  return std::bit_cast<Word>(static_cast<float>(value));
}

// The value is exact where no order of its sums and products rounds.
Word exact(double value) {
  if (static_cast<double>(static_cast<float>(value)) != value || std::fabs(value) > 65536)
    throw Unfit("inexact");
  return bits(value);
}

bool less(Word a, Word b, Base base) {
  if (base == Base::real) return real(a) < real(b);
  return base == Base::integer ? integer(a) < integer(b) : a < b;
}

Word magnitude(Word word, Base base) {
  if (base == Base::real) return bits(std::fabs(real(word)));
  return base == Base::integer && integer(word) < 0 ? Word{0} - word : word;
}

Word clamped(const Words& a, Base base) {
  if (less(a[2], a[1], base)) throw Unfit("clamp");
  return less(a[0], a[1], base) ? a[1] : less(a[2], a[0], base) ? a[2] : a[0];
}

Word sign(Word word, Base base) {
  const Word zero = 0;
  return less(word, zero, base) ? ~Word{0} : less(zero, word, base) ? 1 : 0;
}

Word reversed(Word word) {
  Word result = 0;
  for (int i = 0; i < 32; ++i) result |= (word >> i & 1U) << (31 - i);
  return result;
}

Word highest(Word word, Base base) {
  const Word looked_at = base == Base::integer && integer(word) < 0 ? ~word : word;
  return looked_at == 0 ? ~Word{0} : static_cast<Word>(31 - std::countl_zero(looked_at));
}

Word bounded(double x, double most) {
  if (std::fabs(x) > most) throw Unfit("out of range");
  return bits(x);
}

double smooth(double low, double high, double x) {
  if (low >= high) throw Unfit("smoothstep");
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// These functions work on each component, with all arguments brought to one type.
const std::map<std::string, Componentwise>& componentwise() {
  static const std::map<std::string, Componentwise> all{
      {"abs", [](const Words& a, Base base) { return magnitude(a[0], base); }},
      {"sign", [](const Words& a, Base base) { return sign(a[0], base); }},
      {"min", [](const Words& a, Base base) { return less(a[1], a[0], base) ? a[1] : a[0]; }},
      {"max", [](const Words& a, Base base) { return less(a[0], a[1], base) ? a[1] : a[0]; }},
      {"clamp", clamped},
      {"saturate", [](const Words& a, Base) { return bits(std::clamp(real(a[0]), 0.0, 1.0)); }},
      {"floor", [](const Words& a, Base) { return bits(std::floor(real(a[0]))); }},
      {"ceil", [](const Words& a, Base) { return bits(std::ceil(real(a[0]))); }},
      {"trunc", [](const Words& a, Base) { return bits(std::trunc(real(a[0]))); }},
      {"round", [](const Words& a, Base) { return bits(std::nearbyint(real(a[0]))); }},
      {"frac", [](const Words& a, Base) { return bits(real(a[0]) - std::floor(real(a[0]))); }},
      {"step", [](const Words& a, Base) { return bits(real(a[1]) >= real(a[0]) ? 1 : 0); }},
      {"lerp",
       [](const Words& a, Base) { return exact(real(a[0]) + real(a[2]) * (real(a[1]) - real(a[0]))); }},
      {"mad",
       [](const Words& a, Base base) {
         return base == Base::real ? exact(real(a[0]) * real(a[1]) + real(a[2])) : a[0] * a[1] + a[2];
       }},
      {"fmod",
       [](const Words& a, Base) {
         if (real(a[1]) == 0) throw Unfit("fmod");
         return bits(std::fmod(real(a[0]), real(a[1])));
       }},
      {"smoothstep", [](const Words& a, Base) { return exact(smooth(real(a[0]), real(a[1]), real(a[2]))); }},
      {"ldexp",
       [](const Words& a, Base) { return exact(std::ldexp(real(a[0]), static_cast<int>(real(a[1])))); }},
      {"countbits", [](const Words& a, Base) { return static_cast<Word>(std::popcount(a[0])); }},
      {"reversebits", [](const Words& a, Base) { return reversed(a[0]); }},
      {"firstbithigh", [](const Words& a, Base base) { return highest(a[0], base); }},
      {"firstbitlow",
       [](const Words& a, Base) { return a[0] == 0 ? ~Word{0} : static_cast<Word>(std::countr_zero(a[0])); }},
      {"asuint",
       [](const Words& a, Base base) {
         if (base == Base::real && real(a[0]) == 0) throw Unfit("the sign of zero");
         return a[0];
       }},
      {"asint",
       [](const Words& a, Base base) {
         if (base == Base::real && real(a[0]) == 0) throw Unfit("the sign of zero");
         return a[0];
       }},
      {"isnan", [](const Words&, Base) { return Word{0}; }},
      {"isinf", [](const Words&, Base) { return Word{0}; }},
      {"sqrt",
       [](const Words& a, Base) {
         if (real(a[0]) < 0) throw Unfit("sqrt");
         return bits(std::sqrt(real(a[0])));
       }},
      {"rsqrt",
       [](const Words& a, Base) {
         if (real(a[0]) <= 0) throw Unfit("rsqrt");
         return bits(1 / std::sqrt(real(a[0])));
       }},
      {"rcp",
       [](const Words& a, Base) {
         if (real(a[0]) == 0) throw Unfit("rcp");
         return bits(1 / real(a[0]));
       }},
      {"radians",
       [](const Words& a, Base) { return bounded(real(a[0]) * (3.14159265358979323846 / 180), 1e6); }},
      {"degrees",
       [](const Words& a, Base) { return bounded(real(a[0]) * (180 / 3.14159265358979323846), 1e6); }},
  };
  return all;
}

Word dot(const Value& a, const Value& b, int first, int step_a, int first_b, int step_b, int count) {
  Value sum{scalar(a.type.base), {0}};
  for (int i = 0; i < count; ++i) {
    const Value x{sum.type, {a.words.at(first + i * step_a)}};
    const Value y{sum.type, {b.words.at(first_b + i * step_b)}};
    sum = binary("+", sum, binary("*", x, y));
  }
  return sum.words[0];
}

// Vectors are rows on the left and columns on the right.
Value product(const Type& type, const Value& a, const Value& b) {
  if (a.type.is_scalar() || b.type.is_scalar()) return binary("*", a, b);
  const int inner = a.type.columns;
  const int width = b.type.is_matrix() ? b.type.columns : 1;
  const int height = a.type.is_matrix() ? a.type.rows : 1;
  Value result{type, Words(type.components())};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      result.words.at(row * width + column) = dot(a, b, row * inner, 1, column, width, inner);
  return result;
}

Value transposed(const Type& type, const Value& a) {
  Value result{type, Words(a.words.size())};
  for (int row = 0; row < a.type.rows; ++row)
    for (int column = 0; column < a.type.columns; ++column)
      result.words[column * a.type.rows + row] = a.words[row * a.type.columns + column];
  return result;
}

double minor(const Value& m, std::vector<int> rows, std::vector<int> columns) {
  if (rows.empty()) return 1;
  double sum = 0;
  const int row = rows.front();
  rows.erase(rows.begin());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::vector<int> rest = columns;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    sum += (i % 2 == 0 ? 1 : -1) * real(m.words[row * m.type.columns + columns[i]]) * minor(m, rows, rest);
  }
  return sum;
}

Value determinant(const Value& m) {
  std::vector<int> all(m.type.rows);
  for (int i = 0; i < m.type.rows; ++i) all[i] = i;
  return {scalar(Base::real), {exact(minor(m, all, all))}};
}

Value cross(const Value& a, const Value& b) {
  Value result{vector(Base::real, 3), Words(3)};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    result.words[i] = exact(real(a.words[j]) * real(b.words[k]) - real(a.words[k]) * real(b.words[j]));
  }
  return result;
}

Value length(const Value& a) {
  double sum = 0;
  for (const Word word : a.words) sum += real(word) * real(word);
  return {scalar(Base::real), {bits(std::sqrt(sum))}};
}

Value quantified(bool all, const Value& value) {
  const Value conditions = convert(value, value.type.of_base(Base::boolean));
  const auto met = std::count(conditions.words.begin(), conditions.words.end(), 1U);
  return {scalar(Base::boolean),
          {(all ? met == static_cast<std::ptrdiff_t>(conditions.words.size()) : met > 0) ? 1U : 0U}};
}

}  // namespace

Value intrinsic(const std::string& name, const Type& type, const std::vector<Value>& arguments) {
  if (name == "mul") return product(type, arguments[0], arguments[1]);
  if (name == "transpose") return transposed(type, arguments[0]);
  if (name == "determinant") return determinant(arguments[0]);
  if (name == "cross") return cross(arguments[0], arguments[1]);
  if (name == "length") return length(arguments[0]);
  if (name == "distance") return length(binary("-", arguments[0], arguments[1]));
  if (name == "any" || name == "all") return quantified(name == "all", arguments[0]);
  if (name == "dot") {
    const int count = arguments[0].type.components();
    return {type, {dot(arguments[0], arguments[1], 0, 1, 0, 1, count)}};
  }
  const Componentwise& one = componentwise().at(name);
  Base base = Base::boolean;
  for (const Value& argument : arguments) base = std::max(base, argument.type.base);
  std::vector<Value> operands;
  for (const Value& argument : arguments) operands.push_back(convert(argument, type.of_base(base)));
  Value result{type, Words(type.components())};
  for (std::size_t i = 0; i < result.words.size(); ++i) {
    Words words;
    for (const Value& operand : operands) words.push_back(operand.words[i]);
    result.words[i] = one(words, base);
  }
  return result;
}

}  // namespace penumbra::programs
