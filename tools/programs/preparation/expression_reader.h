// Reads the expressions of a text with the shape of every part, by HLSL's rules: what value_types.h says of
// names and chains, and from there through operators, swizzles, casts, constructors and intrinsic functions.
// Says nothing of a shape rather than guess. Internal to this room.
#pragma once

#include <cstddef>
#include <vector>

#include "preparation/number_shape.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

// The tokens [first, end).
struct ReadOperand {
  std::size_t first = npos;
  std::size_t end = npos;
  NumberShape shape{};
  bool is_term = false;  // binds as much as a cast: no operator between two operands outside of parentheses
};

// Linear time. What stands more than a few hundred parentheses deep is left unread.
class ExpressionReader {
 public:
  explicit ExpressionReader(const TokenText& text);  // good until its apply()
  virtual ~ExpressionReader() = default;
  void read_all();

 protected:
  // For each operator between two operands, inner ones first; the operator's first token. Assignments of "="
  // alone are none.
  virtual void read_binary(const ReadOperand& left, std::size_t op, const ReadOperand& right) = 0;
  virtual void read_assignment(const ReadOperand& /*left*/, std::size_t /*op*/,
                               const ReadOperand& /*right*/) {}
  // For each `condition ? yes : no`; the '?'.
  virtual void read_choice(const ReadOperand& /*condition*/, std::size_t /*mark*/, const ReadOperand& /*yes*/,
                           const ReadOperand& /*no*/) {}
  // For each + - ! ~ and ++ -- before an operand.
  virtual void read_sign(std::size_t /*sign*/, const ReadOperand& /*of*/) {}
  // For each expression in parentheses that are neither a call's nor a cast's.
  virtual void read_parenthesised(std::size_t /*open*/, const NumberShape& /*inside*/) {}
  // For each call of a function that is not the text's; the name, and the shapes of the arguments.
  virtual void read_intrinsic(std::size_t /*name*/, const std::vector<NumberShape>& /*arguments*/) {}
  // For each `.member` that is not called, with the shape of what stands before its '.'.
  virtual void read_member(const NumberShape& /*of*/, std::size_t /*member*/) {}

 private:
  struct Operator {
    std::size_t tokens = 0;  // 0: none
    int precedence = 0;
  };
  Operator operator_at(std::size_t at) const;
  bool begins_operand(std::size_t at) const;
  bool adjacent(std::size_t left) const;
  ReadOperand assignment();
  ReadOperand choice();
  ReadOperand binary(int least);
  ReadOperand term();
  ReadOperand postfix();
  NumberShape primary();
  NumberShape name_or_call();
  std::vector<NumberShape> list(
      std::size_t open);  // of what stands in parentheses; fails where that is no list
  NumberShape function_shape(std::size_t name, const std::vector<NumberShape>& arguments) const;
  NumberShape operator_shape(std::size_t op, const NumberShape& left, const NumberShape& right) const;
  NumberShape after_dot(std::size_t member, const NumberShape& of) const;
  NumberShape known_shape(std::size_t last) const;

  const TokenText& text_;
  const ValueTypes& types_;
  std::vector<bool> functions_;  // by a word's number: whether a function of the text has that name
  std::size_t at_ = 0;
  int depth_ = 0;
  bool failed_ = false;  // no expression stands at at_
};

}  // namespace penumbra::preparation
