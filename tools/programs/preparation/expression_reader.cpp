#include "preparation/expression_reader.h"

#include "hlsl/name_set.h"
#include "preparation/declarators.h"
#include "preparation/postfix_expression.h"

namespace penumbra::preparation {

namespace {

using Base = NumberShape::Base;

bool begins_no_operand(std::string_view word) {
  static constexpr hlsl::NameSet words(
      "return", "if", "else", "for", "while", "do", "switch", "case", "default", "struct", "class", "cbuffer",
      "tbuffer", "namespace", "typedef", "const", "static", "in", "out", "inout", "uniform", "precise",
      "groupshared", "row_major", "column_major", "break", "continue", "discard");
  return words.contains(word);
}

bool gives_scalar(std::string_view function) {
  static constexpr hlsl::NameSet words("length", "distance", "determinant", "any", "all");
  return words.contains(function);
}

// Returns whether the function works on each component of its arguments.
bool is_componentwise(std::string_view function) {
  static constexpr hlsl::NameSet words(
      "abs", "acos", "asin", "atan", "atan2", "ceil", "clamp", "cos", "cosh", "ddx", "ddx_coarse", "ddx_fine",
      "ddy", "ddy_coarse", "ddy_fine", "degrees", "exp", "exp2", "floor", "fmod", "frac", "fwidth", "ldexp",
      "lerp", "log", "log10", "log2", "mad", "max", "min", "normalize", "pow", "radians", "rcp", "reflect",
      "refract", "round", "rsqrt", "saturate", "sin", "sinh", "smoothstep", "sqrt", "step", "tan", "tanh",
      "trunc", "faceforward", "cross");
  return words.contains(function);
}

bool is_swizzle(std::string_view word) {
  return !word.empty() && word.size() <= 4 &&
         (word.find_first_not_of("xyzw") == std::string_view::npos ||
          word.find_first_not_of("rgba") == std::string_view::npos);
}

NumberShape vector_of(Base base, std::size_t size) {
  return {base, 0, size > 1 ? static_cast<int>(size) : 0};
}

NumberShape product_shape(const NumberShape& a, const NumberShape& b) {
  if (!a.known() || !b.known()) return {};
  const Base base = std::max(a.base, b.base);
  if (a.is_scalar()) return b.of_base(base);
  if (b.is_scalar()) return a.of_base(base);
  if (a.is_vector() && b.is_vector()) return {base};
  if (a.is_vector()) return {base, 0, b.columns};
  if (b.is_vector()) return {base, 0, a.rows};
  return {base, a.rows, b.columns};
}

}  // namespace

ExpressionReader::ExpressionReader(const TokenText& text)
    : text_(text), types_(text.types()), functions_(text.identifier_count(), false) {
  for (const FunctionType& function : types_.functions())
    if (function.name != npos && text_.is_identifier(function.name))
      functions_[text_.identifier_number(function.name)] = true;
}

void ExpressionReader::read_all() {
  for (at_ = 0; at_ < text_.size();) {
    const std::size_t before = at_;
    failed_ = false;
    depth_ = 0;
    if (begins_operand(at_)) assignment();
    if (at_ == before) ++at_;
  }
}

bool ExpressionReader::adjacent(std::size_t left) const {
  return left + 1 < text_.size() && text_.word(left).data() + 1 == text_.word(left + 1).data();
}

ExpressionReader::Operator ExpressionReader::operator_at(std::size_t at) const {
  const auto pair = [&](std::string_view second) { return text_.is(at + 1, second) && adjacent(at); };
  if (assignment_length(text_, at) != 0) return {};
  switch (text_.lead(at)) {
    case '*':
    case '/':
    case '%':
      return {1, 10};
    case '+':
    case '-':
      return pair(text_.word(at)) ? Operator{} : Operator{1, 9};
    case '<':
    case '>':
      if (pair(text_.word(at))) return {2, 8};
      return {pair("=") ? 2U : 1U, 7};
    case '=':
    case '!':
      return pair("=") ? Operator{2, 6} : Operator{};
    case '&':
      return pair("&") ? Operator{2, 2} : Operator{1, 5};
    case '^':
      return {1, 4};
    case '|':
      return pair("|") ? Operator{2, 1} : Operator{1, 3};
    default:
      return {};
  }
}

bool ExpressionReader::begins_operand(std::size_t at) const {
  if (at >= text_.size()) return false;
  if (text_.is_identifier(at)) return !begins_no_operand(text_.word(at));
  return text_.is_number(at) || std::string_view("(+-!~").find(text_.lead(at)) != std::string_view::npos;
}

ReadOperand ExpressionReader::assignment() {
  const ReadOperand left = choice();
  if (failed_) return left;
  const std::size_t marks = assignment_length(text_, at_);
  if (marks == 0) return left;
  const std::size_t op = at_;
  at_ += marks;
  const ReadOperand right = assignment();
  if (!failed_ && marks > 1) read_assignment(left, op, right);
  return {left.first, right.end, left.shape};
}

ReadOperand ExpressionReader::choice() {
  const ReadOperand condition = binary(1);
  if (failed_ || !text_.is(at_, "?")) return condition;
  ++at_;
  const ReadOperand yes = assignment();
  if (failed_ || !text_.is(at_, ":")) {
    failed_ = true;
    return condition;
  }
  ++at_;
  const ReadOperand no = assignment();
  const NumberShape& a = yes.shape;
  const NumberShape shape = a == no.shape ? a : combined_shape(a, no.shape);
  return {condition.first, no.end, condition.shape.is_scalar() ? shape : NumberShape{}};
}

ReadOperand ExpressionReader::binary(int least) {
  ReadOperand left = term();
  while (!failed_) {
    const Operator op = operator_at(at_);
    if (op.tokens == 0 || op.precedence < least) break;
    const std::size_t mark = at_;
    at_ += op.tokens;
    const ReadOperand right = binary(op.precedence + 1);
    if (failed_) break;
    read_binary(left, mark, right);
    left = {left.first, right.end, operator_shape(mark, left.shape, right.shape)};
  }
  return left;
}

NumberShape ExpressionReader::operator_shape(std::size_t op, const NumberShape& left,
                                             const NumberShape& right) const {
  const NumberShape both = combined_shape(left, right);
  switch (operator_at(op).precedence) {
    case 7:
    case 6:
    case 2:
    case 1:
      return both.of_base(Base::boolean);
    default:
      return both;
  }
}

// Reads signs and casts in front of a postfix expression.
ReadOperand ExpressionReader::term() {
  constexpr int deepest = 300;
  const std::size_t first = at_;
  if (!begins_operand(at_) || depth_ == deepest) {
    failed_ = true;
    return {};
  }
  ++depth_;
  ReadOperand result;
  const bool sign = text_.is_any(at_, "+", "-", "!", "~");
  const bool cast = text_.is(at_, "(") && text_.is_identifier(at_ + 1) && text_.is(at_ + 2, ")") &&
                    (is_number_type(text_.word(at_ + 1)) || types_.structs().contains(text_.word(at_ + 1)));
  if (sign) {
    const bool logical = text_.is(at_, "!");
    at_ += text_.is_any(at_, "+", "-") && text_.is(at_ + 1, text_.word(at_)) && adjacent(at_) ? 2 : 1;
    result = term();
    if (logical) result.shape = result.shape.of_base(Base::boolean);
  } else if (cast) {
    const NumberShape shape = shape_of_type(text_.word(at_ + 1));
    at_ += 3;
    result = term();
    result.shape = shape;
  } else {
    result = postfix();
  }
  --depth_;
  return {first, result.end, result.shape, true};
}

ReadOperand ExpressionReader::postfix() {
  const std::size_t first = at_;
  NumberShape shape = primary();
  while (!failed_) {
    if (text_.is(at_, ".") && text_.is_identifier(at_ + 1)) {
      at_ += 2;
      const bool call = text_.is(at_, "(");
      if (call) list(at_);
      const NumberShape known = known_shape(at_ - 1);
      shape = known.known() || call ? known : after_dot(at_ - 1, shape);
    } else if (text_.is(at_, "[") && text_.matching_bracket(at_) != npos) {
      list(at_);
      const NumberShape known = known_shape(at_ - 1);
      if (known.known() || !shape.known()) {
        shape = known;
      } else {
        shape = shape.is_matrix() ? NumberShape{shape.base, 0, shape.columns} : NumberShape{shape.base};
      }
    } else if (text_.is_any(at_, "+", "-") && text_.is(at_ + 1, text_.word(at_)) && adjacent(at_)) {
      at_ += 2;
    } else {
      break;
    }
  }
  return {first, at_, shape, true};
}

// Returns the shape of the chain that ends with this token, by its declaration.
NumberShape ExpressionReader::known_shape(std::size_t last) const {
  const ValueType& type = types_.at(last);
  return type.dimensions > 0 || type.name.empty() ? NumberShape{} : shape_of_type(type.name);
}

NumberShape ExpressionReader::after_dot(std::size_t member, const NumberShape& of) const {
  const std::string_view word = text_.word(member);
  if (!of.known()) return {};
  if (!of.is_matrix()) return is_swizzle(word) ? vector_of(of.base, word.size()) : NumberShape{};
  if (word.size() < 3 || word[0] != '_') return {};
  return vector_of(of.base, word.size() / (word[1] == 'm' ? 4 : 3));
}

NumberShape ExpressionReader::primary() {
  if (text_.is_number(at_)) return shape_of_number(text_.word(at_++));
  if (!text_.is(at_, "(")) return name_or_call();
  const std::vector<NumberShape> inside = list(at_);
  if (failed_ || inside.size() != 1) return {};
  return inside[0];
}

NumberShape ExpressionReader::name_or_call() {
  const std::size_t name = at_++;
  if (text_.is_any(name, "true", "false")) return {Base::boolean};
  if (text_.is(at_, ":") && text_.is(at_ + 1, ":")) {
    at_ += 2;
    return {};
  }
  if (!text_.is(at_, "(")) return known_shape(name);
  const std::vector<NumberShape> arguments = list(at_);
  if (failed_) return {};
  const NumberShape known = known_shape(at_ - 1);
  return known.known() ? known : function_shape(name, arguments);
}

std::vector<NumberShape> ExpressionReader::list(std::size_t open) {
  const std::size_t close = text_.matching_bracket(open);
  if (close == npos) failed_ = true;
  std::vector<NumberShape> all;
  at_ = open + 1;
  while (!failed_ && at_ < close) {
    all.push_back(assignment().shape);
    if (failed_) break;
    if (at_ != close && !text_.is(at_, ",")) failed_ = true;
    if (text_.is(at_, ",")) ++at_;
  }
  if (!failed_) at_ = close + 1;
  return all;
}

NumberShape ExpressionReader::function_shape(std::size_t name,
                                             const std::vector<NumberShape>& arguments) const {
  const std::string_view word = text_.word(name);
  if (is_number_type(word)) return shape_of_type(word);
  if (functions_[text_.identifier_number(name)] || arguments.empty()) return {};
  const NumberShape& first = arguments[0];
  if (word == "mul" && arguments.size() == 2) return product_shape(first, arguments[1]);
  if (word == "transpose") return {first.base, first.columns, first.rows};
  if (word == "sign") return first.of_base(Base::integer);
  if (word == "asfloat") return first.of_base(Base::real);
  if (word == "asint") return first.of_base(Base::integer);
  if (word == "asuint") return first.of_base(Base::natural);
  if (word == "dot" && arguments.size() == 2) return {combined_shape(first, arguments[1]).base};
  if (gives_scalar(word)) return {word == "any" || word == "all" ? Base::boolean : Base::real};
  if (!is_componentwise(word)) return {};
  NumberShape all = first;
  for (const NumberShape& argument : arguments) all = argument == all ? all : combined_shape(all, argument);
  return all;
}

}  // namespace penumbra::preparation
