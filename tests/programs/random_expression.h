// Makes random expressions of a wanted type.
//
// Floats stay multiples of 1/64 below 65536 by construction: factors are brought to small numbers first, so
// that no sum or product rounds and the order in which a compiler takes them does not matter. Divisors are
// not zero, shifts are below 32, indices are inside. The interpreter finds what is left, and refuses the
// program.
#pragma once

#include <functional>
#include <optional>

#include "programs/scope.h"

namespace penumbra::programs {

class RandomExpression {
 public:
  RandomExpression(Program& program, Scope& scope, Chance& chance)
      : program_(program), scope_(scope), chance_(chance) {}

  Expression of(const Type& type, int depth);           // expression of that type
  Expression convertible(const Type& type, int depth);  // expression that an assignment converts to it
  Expression argument(const Type& type, int depth);     // argument of a call: glslang cuts no matrices there
  std::optional<Expression> place(const Type& type, bool writable);
  Expression construct(const Type& type,
                       int depth);  // of its parts; of arrays and structures: an initialiser alone
  Expression rounded();             // a float that is right to 2 ULP and good for nothing but to be stored

  // These functions may be called in the midst of an expression: they write nothing outside of them.
  std::vector<int> pure_functions;

 private:
  Expression leaf(const Type& type);
  Expression literal(Base base);
  Expression tame(const Expression& value);
  Expression tame_of(const Type& type, int depth);
  Expression small(const Expression& value);
  Expression divisor(const Type& type, int depth);
  Expression index(int size, bool simple);  // simple: the index may be read twice
  Expression boolean(const Type& type, int depth);
  Expression whole(const Type& type, int depth);
  Expression real(const Type& type, int depth);
  Expression matrix(const Type& type, int depth);
  Expression general(const Type& type, int depth);
  Expression other_shape(const Type& type, int depth);
  Expression operand(const Type& type, int depth);
  Expression componentwise(const Type& type, int depth);
  std::optional<Expression> part_of(const Expression& whole, const Type& wanted, bool writable);
  std::optional<Expression> swizzle(const Expression& of, const Type& wanted, bool writable);
  std::optional<Expression> call(const Type& type, int depth);

  Program& program_;
  Scope& scope_;
  Chance& chance_;
  bool within_index_ = false;
};

}  // namespace penumbra::programs
