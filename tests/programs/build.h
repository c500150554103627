// Builds expressions from their parts.
#pragma once

#include <bit>
#include <string>
#include <utility>
#include <vector>

#include "programs/program.h"

namespace penumbra::programs::build {

inline Expression number(Base base, double value) {
  Expression made;
  made.type = scalar(base);
  made.bits = base == Base::real      ? std::bit_cast<std::uint32_t>(static_cast<float>(value))
              : base == Base::integer ? static_cast<std::uint32_t>(static_cast<std::int32_t>(value))
                                      : static_cast<std::uint32_t>(value);
  return made;
}

inline Expression with_parts(Expression::Kind kind, const Type& type, std::string name,
                             std::vector<Expression> parts) {
  Expression made;
  made.kind = kind;
  made.type = type;
  made.name = std::move(name);
  made.parts = std::move(parts);
  return made;
}

inline Expression binary(const std::string& op, const Type& type, Expression a, Expression b) {
  return with_parts(Expression::Kind::binary, type, op, {std::move(a), std::move(b)});
}

inline Expression unary(const std::string& op, const Type& type, Expression of) {
  return with_parts(Expression::Kind::unary, type, op, {std::move(of)});
}

inline Expression intrinsic(const std::string& name, const Type& type, std::vector<Expression> arguments) {
  return with_parts(Expression::Kind::intrinsic, type, name, std::move(arguments));
}

inline Expression cast(const Type& type, Expression of) {
  return with_parts(Expression::Kind::cast, type, "", {std::move(of)});
}

inline Expression variable(int number, const Type& type) {
  Expression made;
  made.kind = Expression::Kind::variable;
  made.type = type;
  made.number = number;
  return made;
}

inline Expression element(const Type& type, Expression of, Expression index) {
  return with_parts(Expression::Kind::element, type, "", {std::move(of), std::move(index)});
}

inline Expression member(const Type& type, Expression of, int number) {
  Expression made = with_parts(Expression::Kind::member, type, "", {std::move(of)});
  made.number = number;
  return made;
}

}  // namespace penumbra::programs::build
