#include "programs/random_expression.h"

#include "programs/arithmetic.h"
#include "programs/build.h"

namespace penumbra::programs {

using build::binary;
using build::cast;
using build::intrinsic;
using build::number;
using build::unary;

Expression RandomExpression::of(const Type& type, int depth) {
  if (depth <= 0 || !type.is_number()) return leaf(type);
  if (chance_.percent(30)) return general(type, depth - 1);
  if (type.is_matrix() && chance_.percent(60)) return matrix(type, depth - 1);
  if (type.base == Base::boolean) return boolean(type, depth - 1);
  return type.base == Base::real ? real(type, depth - 1) : whole(type, depth - 1);
}

Expression RandomExpression::leaf(const Type& type) {
  if (chance_.percent(75))
    if (std::optional<Expression> found = place(type, false)) return *std::move(found);
  if (!type.is_number()) return cast(type, number(Base::integer, 0));
  if (!type.is_scalar())
    return chance_.percent(70) ? construct(type, 0) : cast(type, leaf(scalar(type.base)));
  if (type.base == Base::boolean || chance_.percent(50)) return literal(type.base);
  Expression input;
  input.kind = Expression::Kind::input;
  input.type = type;
  input.number = (type.base == Base::real ? 0 : type.base == Base::integer ? 4 : 8) + chance_.below(4);
  return input;
}

Expression RandomExpression::literal(Base base) {
  if (base == Base::boolean) return number(base, chance_.below(2));
  if (base == Base::natural)
    return number(base, chance_.percent(80) ? chance_.below(20) : chance_.word() >> 1);
  if (base == Base::integer)
    return number(base, chance_.percent(80) ? chance_.between(-9, 20) : chance_.between(-100000, 100000));
  return number(base, chance_.between(-16, 32) / 4.0);
}

// A float between -8 and 8, a multiple of a quarter.
Expression RandomExpression::tame(const Expression& value) {
  static const std::vector<std::string> roundings{"round", "floor", "ceil", "trunc"};
  const Type& type = value.type;
  if (value.kind == Expression::Kind::literal) return value;
  Expression whole = intrinsic(
      "clamp", type,
      {intrinsic(chance_.of(roundings), type, {value}), number(Base::real, -8), number(Base::real, 8)});
  return chance_.percent(70) ? whole : binary("*", type, std::move(whole), number(Base::real, 0.25));
}

// What glslang does with whole matrices by elements are + - * / % alone, so a matrix has tame rows.
Expression RandomExpression::tame_of(const Type& type, int depth) {
  if (!type.is_matrix()) return tame(of(type, depth));
  std::vector<Expression> rows;
  for (int row = 0; row < type.rows; ++row) rows.push_back(tame(of(vector(type.base, type.columns), depth)));
  return build::with_parts(Expression::Kind::construct, type, "", std::move(rows));
}

// A whole number that a float holds.
Expression RandomExpression::small(const Expression& value) {
  if (value.kind == Expression::Kind::literal || value.type.base == Base::boolean) return value;
  return binary("&", value.type, value, number(value.type.base, 63));
}

Expression RandomExpression::divisor(const Type& type, int depth) {
  const bool negative = type.base != Base::natural && chance_.percent(40);
  const Expression one = number(type.base, 1);
  Expression size = type.base == Base::real ? intrinsic("abs", type, {tame(of(type, depth))})
                                            : binary("&", type, of(type, depth), number(type.base, 7));
  Expression positive = binary("+", type, std::move(size), one);
  if (!negative) return positive;
  return binary("-", type, type.base == Base::real ? number(Base::real, 0) : number(type.base, -1),
                std::move(positive));
}

Expression RandomExpression::convertible(const Type& type, int depth) {
  if (!type.is_number() || chance_.percent(75)) return of(type, depth);
  if (chance_.percent(40)) return other_shape(type, depth);
  const Base base = type.is_matrix() ? type.base : static_cast<Base>(chance_.below(4));
  if (base == Base::real && type.base == Base::natural)
    return intrinsic("abs", type.of_base(base), {of(type.of_base(base), depth)});
  Expression value = of(type.of_base(base), depth);
  return type.base == Base::real && base != Base::real ? small(value) : value;
}

Expression RandomExpression::argument(const Type& type, int depth) {
  return type.is_matrix() ? of(type, depth) : convertible(type, depth);
}

// A scalar for every component, or a vector of which the first components count.
Expression RandomExpression::other_shape(const Type& type, int depth) {
  if (type.is_vector() && type.columns < 4 && chance_.percent(50))
    return of(vector(type.base, type.columns + 1), depth);
  if (type.is_matrix() && type.rows < 4 && type.columns < 4 && chance_.percent(50))
    return of({type.base, type.rows + 1, type.columns + chance_.below(2)}, depth);
  return of(scalar(type.base), depth);
}

// An operand beside one of that type: of the same type, of a lower base, or a scalar.
Expression RandomExpression::operand(const Type& type, int depth) {
  if (chance_.percent(20)) return type.is_matrix() ? of(scalar(type.base), depth) : other_shape(type, depth);
  if (chance_.percent(80) || type.base == Base::boolean || type.is_matrix()) return of(type, depth);
  return small(of(type.of_base(static_cast<Base>(chance_.below(static_cast<int>(type.base)))), depth));
}

Expression RandomExpression::general(const Type& type, int depth) {
  switch (chance_.below(5)) {
    case 0: {
      const Type condition =
          chance_.percent(60) || type.is_matrix() ? scalar(Base::boolean) : type.of_base(Base::boolean);
      return build::with_parts(Expression::Kind::choice, type, "",
                               {of(condition, depth), of(type, depth), of(type, depth)});
    }
    case 1:
      return cast(type, convertible(type, depth));
    case 2:
      return construct(type, depth);
    case 3:
      if (std::optional<Expression> result = call(type, depth)) return *std::move(result);
      break;
    default:
      break;
  }
  if (type.is_matrix()) return leaf(type);
  const Type from = vector(type.base, chance_.between(2, 4));
  if (std::optional<Expression> picked = swizzle(of(from, depth), type, false)) return *std::move(picked);
  return leaf(type);
}

Expression RandomExpression::boolean(const Type& type, int depth) {
  static const std::vector<std::string> comparisons{"<", ">", "<=", ">=", "==", "!="};
  const int way = chance_.below(10);
  if (way < 5) {
    const Type compared = type.of_base(static_cast<Base>(chance_.between(1, 3)));
    Expression left = of(compared, depth);
    Expression right = type.is_scalar() ? of(compared, depth) : operand(compared, depth);
    if (right.type != compared && common_type(compared, right.type) != compared) right = of(compared, depth);
    return binary(chance_.of(comparisons), type, std::move(left), std::move(right));
  }
  if (way < 8) return binary(chance_.percent(50) ? "&&" : "||", type, of(type, depth), of(type, depth));
  if (way < 9 || !type.is_scalar()) return unary("!", type, of(type, depth));
  const Type several = vector(static_cast<Base>(chance_.below(4)), chance_.between(2, 4));
  return intrinsic(chance_.percent(50) ? "any" : "all", type, {of(several, depth)});
}

Expression RandomExpression::whole(const Type& type, int depth) {
  static const std::vector<std::string> operators{"+", "-", "*", "&", "|", "^"};
  const int way = chance_.below(12);
  if (way < 5) {
    Expression left = of(type, depth);
    Expression right = operand(type, depth);
    return chance_.percent(50) ? binary(chance_.of(operators), type, std::move(left), std::move(right))
                               : binary(chance_.of(operators), type, std::move(right), std::move(left));
  }
  if (way < 7) return binary(chance_.percent(50) ? "/" : "%", type, of(type, depth), divisor(type, depth));
  if (way < 8) {
    Expression amount = chance_.percent(50) ? number(type.base, chance_.below(32))
                                            : binary("&", type, of(type, depth), number(type.base, 31));
    return binary(chance_.percent(50) ? "<<" : ">>", type, of(type, depth), std::move(amount));
  }
  if (way < 9) return unary(chance_.percent(50) ? "-" : "~", type, of(type, depth));
  return componentwise(type, depth);
}

Expression RandomExpression::real(const Type& type, int depth) {
  const int way = chance_.below(12);
  if (way < 4) {
    Expression left = of(type, depth);
    Expression right = operand(type, depth);
    if (chance_.percent(50)) std::swap(left, right);
    return binary(chance_.percent(50) ? "+" : "-", type, std::move(left), std::move(right));
  }
  if (way < 6) {
    Expression left = tame_of(type, depth);
    const bool alike = !type.is_matrix() && chance_.percent(70);
    Expression right = tame_of(alike ? type : scalar(Base::real), depth);
    if (chance_.percent(50)) std::swap(left, right);
    return binary("*", type, std::move(left), std::move(right));
  }
  if (way < 7)
    return binary("%", type, tame_of(type, depth),
                  divisor(type.is_matrix() ? scalar(type.base) : type, depth));
  if (way < 8) return binary("/", type, tame_of(type, depth), number(Base::real, 1 << chance_.below(3)));
  if (way < 9) return unary("-", type, of(type, depth));
  if (type.is_scalar() && chance_.percent(25)) {
    const Type several = vector(Base::real, chance_.between(2, 4));
    return intrinsic("dot", type, {tame(of(several, depth)), tame(of(several, depth))});
  }
  if (type.is_vector() && chance_.percent(25)) {
    const int other = chance_.between(2, 4);
    const Expression row = tame(of(vector(Base::real, other), depth));
    if (chance_.percent(50))
      return intrinsic("mul", type, {row, tame_of({Base::real, other, type.columns}, depth)});
    return intrinsic("mul", type, {tame_of({Base::real, type.columns, other}, depth), row});
  }
  if (type == vector(Base::real, 3) && chance_.percent(20))
    return intrinsic("cross", type, {tame(of(type, depth)), tame(of(type, depth))});
  return type.is_matrix() ? matrix(type, depth) : componentwise(type, depth);
}

Expression RandomExpression::matrix(const Type& type, int depth) {
  const int way = chance_.below(6);
  if (way < 1) return intrinsic("transpose", type, {of({type.base, type.columns, type.rows}, depth)});
  if (way < 2 && type.base == Base::real) {
    const int inner = chance_.between(2, 4);
    return intrinsic(
        "mul", type,
        {tame_of({type.base, type.rows, inner}, depth), tame_of({type.base, inner, type.columns}, depth)});
  }
  return construct(type, depth);
}

Expression RandomExpression::componentwise(const Type& type, int depth) {
  static const std::vector<std::pair<std::string, int>> of_reals{
      {"abs", 1},  {"min", 2},   {"max", 2},   {"saturate", 1}, {"floor", 1},
      {"ceil", 1}, {"trunc", 1}, {"round", 1}, {"frac", 1},     {"step", 2}};
  static const std::vector<std::pair<std::string, int>> of_tame_reals{{"lerp", 3}, {"mad", 3}};
  static const std::vector<std::pair<std::string, int>> of_wholes{
      {"abs", 1}, {"min", 2}, {"max", 2}, {"mad", 3}};
  const bool is_real = type.base == Base::real;
  if (chance_.percent(10)) {
    Expression low = literal(type.base);
    Expression high = number(type.base, 100);
    if (type.base == Base::natural) low = number(type.base, chance_.below(50));
    if (type.base == Base::integer) low = number(type.base, chance_.between(-50, 50));
    return intrinsic("clamp", type, {of(type, depth), std::move(low), std::move(high)});
  }
  if (is_real && chance_.percent(10))
    return intrinsic("fmod", type, {tame(of(type, depth)), divisor(type, depth)});
  if (!is_real && chance_.percent(25)) {
    static const std::vector<std::string> on_bits{"countbits", "reversebits", "firstbithigh", "firstbitlow"};
    if (type.base == Base::natural) return intrinsic(chance_.of(on_bits), type, {of(type, depth)});
    return intrinsic("sign", type, {of(chance_.percent(50) ? type : type.of_base(Base::real), depth)});
  }
  const bool tamed = is_real && chance_.percent(20);
  const auto& [name, count] = chance_.of(!is_real ? of_wholes : tamed ? of_tame_reals : of_reals);
  std::vector<Expression> arguments;
  for (int i = 0; i < count; ++i) {
    const bool splat = i > 0 && chance_.percent(20);
    Expression argument = of(splat ? scalar(type.base) : type, depth);
    arguments.push_back(tamed ? tame(argument) : std::move(argument));
  }
  return intrinsic(name, type, std::move(arguments));
}

Expression RandomExpression::construct(const Type& type, int depth) {
  std::vector<Expression> parts;
  if (type.length > 0) {
    for (int i = 0; i < type.length; ++i) parts.push_back(of(type.element(), depth));
  } else if (type.structure >= 0) {
    for (const Type& member : program_.structures[type.structure].members) parts.push_back(of(member, depth));
  } else if (type.is_scalar()) {
    return cast(type, of(type, depth));
  } else if (type.is_matrix() && chance_.percent(50)) {
    for (int row = 0; row < type.rows; ++row) parts.push_back(of(vector(type.base, type.columns), depth));
  } else {
    for (int left = type.components(); left > 0;) {
      const int size = type.is_matrix() ? 1 : chance_.between(1, std::min(left, 3));
      parts.push_back(of(size == 1 ? scalar(type.base) : vector(type.base, size), depth));
      left -= size;
    }
  }
  return build::with_parts(Expression::Kind::construct, type, "", std::move(parts));
}

std::optional<Expression> RandomExpression::call(const Type& type, int depth) {
  for (const int number : pure_functions) {
    const Function& function = program_.functions[number];
    if (!function.gives || function.type != type) continue;
    Expression made;
    made.kind = Expression::Kind::call;
    made.type = type;
    made.number = number;
    for (const int parameter : function.parameters)
      made.parts.push_back(argument(program_.variables[parameter].type, depth));
    return made;
  }
  return {};
}

Expression RandomExpression::rounded() {
  const Type one = scalar(Base::real);
  const Type several = vector(Base::real, chance_.between(2, 4));
  switch (chance_.below(6)) {
    case 0:
      return binary("/", one, tame(of(one, 2)), divisor(one, 2));
    case 1:
      return intrinsic("sqrt", one, {intrinsic("abs", one, {of(one, 2)})});
    case 2:
      return intrinsic("rcp", one, {divisor(one, 2)});
    case 3:
      return intrinsic("length", one, {tame(of(several, 2))});
    case 4:
      return intrinsic("distance", one, {tame(of(several, 2)), tame(of(several, 2))});
    default:
      return intrinsic("rsqrt", one, {intrinsic("abs", one, {divisor(one, 2)})});
  }
}

}  // namespace penumbra::programs
