// Variables and parts of them.
#include <algorithm>

#include "programs/build.h"
#include "programs/random_expression.h"

namespace penumbra::programs {

using build::binary;
using build::number;

Expression RandomExpression::index(int size, bool simple) {
  if (within_index_ || chance_.percent(simple ? 70 : 40)) return number(Base::integer, chance_.below(size));
  within_index_ = true;
  const Type type = scalar(chance_.percent(50) ? Base::integer : Base::natural);
  const Expression any = simple ? place(type, false).value_or(number(type.base, 0)) : of(type, 1);
  within_index_ = false;
  if (size == 2 || size == 4) return binary("&", any.type, any, number(any.type.base, size - 1));
  if (any.type.base == Base::natural) return binary("%", any.type, any, number(Base::natural, size));
  return binary("%", any.type, binary("&", any.type, any, number(Base::integer, 63)),
                number(Base::integer, size));
}

std::optional<Expression> RandomExpression::swizzle(const Expression& of, const Type& wanted, bool writable) {
  const int size = wanted.is_scalar() ? 1 : wanted.columns;
  if (wanted.is_matrix() || of.type.base != wanted.base || !of.type.is_number() || of.type.is_scalar())
    return {};
  std::vector<int> all;
  for (int row = 0; row < std::max(of.type.rows, 1); ++row)
    for (int column = 0; column < of.type.columns; ++column)
      all.push_back(of.type.is_matrix() ? row * 4 + column : column);
  if (writable && size > static_cast<int>(all.size())) return {};
  Expression made = build::with_parts(Expression::Kind::swizzle, wanted, "", {of});
  for (int i = 0; i < size; ++i) {
    const int at = chance_.below(static_cast<int>(all.size()));
    made.picks.push_back(all[at]);
    if (writable) all.erase(all.begin() + at);
  }
  return made;
}

// A part of that type: the whole itself, or a member, element or swizzle of it.
std::optional<Expression> RandomExpression::part_of(const Expression& whole, const Type& wanted,
                                                    bool writable) {
  const Type& type = whole.type;
  if (type == wanted && (!type.is_vector() || chance_.percent(70))) return whole;
  if (type.length > 0)
    return part_of(build::element(type.element(), whole, index(type.length, writable)), wanted, writable);
  if (type.structure >= 0) {
    const std::vector<Type>& members = program_.structures[type.structure].members;
    const int count = static_cast<int>(members.size());
    const int first = chance_.below(count);
    for (int i = 0; i < count; ++i) {
      const int at = (first + i) % count;
      if (std::optional<Expression> part = part_of(build::member(members[at], whole, at), wanted, writable))
        return part;
    }
    return {};
  }
  if (type.base != wanted.base || type.is_scalar() || wanted.is_matrix() || !wanted.is_number()) return {};
  if (chance_.percent(50)) return swizzle(whole, wanted, writable);
  const Type row = type.is_matrix() ? vector(type.base, type.columns) : scalar(type.base);
  Expression at = index(type.is_matrix() ? type.rows : type.columns, writable);
  return part_of(build::element(row, whole, std::move(at)), wanted, writable);
}

std::optional<Expression> RandomExpression::place(const Type& type, bool writable) {
  const std::vector<int> visible = scope_.visible();
  if (visible.empty()) return {};
  const int first = chance_.below(static_cast<int>(visible.size()));
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const int number = visible[(static_cast<std::size_t>(first) + i) % visible.size()];
    const Variable& variable = program_.variables[number];
    if (writable && !variable.writable) continue;
    if (std::optional<Expression> part = part_of(build::variable(number, variable.type), type, writable))
      return part;
  }
  return {};
}

}  // namespace penumbra::programs
