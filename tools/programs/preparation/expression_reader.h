// Parses the expressions of a text and determines the shape of every subexpression by HLSL's rules: from the
// names and chains that value_types.h knows, through operators, swizzles, casts, constructors and intrinsic
// functions. An uncertain shape is unknown instead of guessed. Internal to this folder.
#pragma once

#include "preparation/number_shape.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

// An operand with the tokens [first, end).
struct ReadOperand {
  std::size_t first = npos;
  std::size_t end = npos;
  NumberShape shape{};
  bool is_term = false;  // binds as tightly as a cast: no binary operator outside of parentheses
};

// Reading takes linear time. Expressions in more than a few hundred levels of parentheses are skipped.
class ExpressionReader {
 public:
  explicit ExpressionReader(const TokenText& text);  // valid until its apply()
  virtual ~ExpressionReader() = default;
  void read_all();

 protected:
  // It is called for each binary operator, inner ones first; `op` is the operator's first token. It is not
  // called for plain assignments with "=".
  virtual void read_binary(const ReadOperand& left, std::size_t op, const ReadOperand& right) = 0;
  virtual void read_assignment(const ReadOperand& /*left*/, std::size_t /*op*/,
                               const ReadOperand& /*right*/) {}

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
      std::size_t open);  // the elements in the parentheses; fails if they are not a list
  NumberShape function_shape(std::size_t name, const std::vector<NumberShape>& arguments) const;
  NumberShape operator_shape(std::size_t op, const NumberShape& left, const NumberShape& right) const;
  NumberShape after_dot(std::size_t member, const NumberShape& of) const;
  NumberShape known_shape(std::size_t last) const;

  const TokenText& text_;
  const ValueTypes& types_;
  std::vector<bool> functions_;  // for each identifier number: a function of the text has that name
  std::size_t at_ = 0;
  int depth_ = 0;
  bool failed_ = false;  // there is no expression at at_
};

}  // namespace penumbra::preparation
