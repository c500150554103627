// Operators between matrices, which HLSL applies element by element
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-per-component-math).
//
// `m * n` and `m *= n`: glslang silently multiplies the matrices as mul() does. The operator is replaced by a
// function that multiplies row by row; if the type of one operand is unknown, overload resolution selects the
// matrix or the scalar version.
//
// `(float3x3)m + n` with n a float4x4: HLSL drops the rows and columns that the smaller matrix does not have
// (warning X3206), glslang reports an error. The larger one is cast to the type of the smaller.
//
// At least one operand must be a name, member, element or call whose type is known (value_types.h), a cast or
// constructor of a matrix, or composed of these by parentheses, operators, mul() and transpose(). Linear
// time.

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "preparation/expression_reader.h"
#include "preparation/passes.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

constexpr std::string_view product_function = "penumbra_times";

// A text that is inserted around the tokens [first, end); such ranges may be nested.
struct Wrap {
  std::size_t first;
  std::size_t end;
  std::string before;
  bool closed;  // true if a ')' closes it
};

class MatrixOperators final : public ExpressionReader {
 public:
  explicit MatrixOperators(TokenText& text) : ExpressionReader(text), text_(text) {}

  void run() {
    read_all();
    insert_wraps();
    std::string functions;
    for (const auto& [type, shape] : shapes_) functions += definitions(shape);
    if (!functions.empty()) text_.insert(0, functions);
    text_.apply();
  }

 private:
  void read_binary(const ReadOperand& left, std::size_t op, const ReadOperand& right) override {
    if (!left.shape.is_matrix() && !right.shape.is_matrix()) return;
    const bool product = text_.is(op, "*");
    if (product && (left.shape.is_vector() || right.shape.is_vector())) return refuse(op);
    if (product && !left.shape.is_scalar() && !right.shape.is_scalar()) {
      remember(left);
      remember(right);
      wraps_.push_back({left.first, right.end, std::string(product_function) + "(", true});
      text_.replace(op, 1, ",");
    }
    cast_the_larger(left, right);
  }

  // Replaces m *= n; by m = penumbra_times(m, n);
  void read_assignment(const ReadOperand& left, std::size_t op, const ReadOperand& right) override {
    if (!text_.is(op, "*") || !left.shape.is_matrix() || right.shape.is_scalar()) return;
    if (right.shape.is_vector()) return refuse(op);
    if (!may_be_repeated(text_, left.first, left.end)) return;
    remember(left);
    remember(right);
    text_.replace(
        op, 2, "= " + std::string(product_function) + "(" + text_.spelled(left.first, op - left.first) + ",");
    wraps_.push_back({op + 2, right.end, "", true});
  }

  void refuse(std::size_t op) {
    text_.error(op, "'*' does not combine a vector with a matrix; mul() is the product of linear algebra");
  }

  void cast_the_larger(const ReadOperand& left, const ReadOperand& right) {
    const NumberShape& a = left.shape;
    const NumberShape& b = right.shape;
    if (!a.is_matrix() || !b.is_matrix() || (a.rows == b.rows && a.columns == b.columns)) return;
    if (a.rows <= b.rows && a.columns <= b.columns) {
      cast(right, {b.base, a.rows, a.columns});
    } else if (b.rows <= a.rows && b.columns <= a.columns) {
      cast(left, {a.base, b.rows, b.columns});
    }
  }

  void cast(const ReadOperand& operand, const NumberShape& to) {
    const std::string type = "(" + type_of_shape(to) + ")";
    wraps_.push_back({operand.first, operand.end, operand.is_term ? type : type + "(", !operand.is_term});
  }

  // Outer wraps come first. Of two around the same tokens the later one is the outer one, because inner
  // operators are read first.
  void insert_wraps() {
    std::vector<std::size_t> order(wraps_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return wraps_[a].end != wraps_[b].end ? wraps_[a].end > wraps_[b].end : a > b;
    });
    for (const std::size_t i : order) {
      if (!wraps_[i].before.empty()) text_.insert(wraps_[i].first, wraps_[i].before);
      if (wraps_[i].closed) text_.insert(wraps_[i].end, ")");
    }
  }

  void remember(const ReadOperand& operand) {
    if (operand.shape.is_matrix()) shapes_[type_of_shape(operand.shape)] = operand.shape;
  }

  // The functions multiply row by row, and by a scalar on either side.
  static std::string definitions(const NumberShape& shape) {
    const std::string type = type_of_shape(shape);
    const std::string scalar = type_of_shape({shape.base});
    const std::string head = type + " " + std::string(product_function) + "(";
    std::string rows;
    for (int row = 0; row < shape.rows; ++row) {
      const std::string i = "[" + std::to_string(row) + "]";
      rows.append(rows.empty() ? "" : ", ").append("a").append(i).append(" * b").append(i);
    }
    return head + type + " a, " + type + " b) { return " + type + "(" + rows + "); } " + head + type +
           " a, " + scalar + " b) { return a * b; } " + head + scalar + " a, " + type +
           " b) { return a * b; }\n";
  }

  TokenText& text_;
  std::vector<Wrap> wraps_;
  std::map<std::string, NumberShape> shapes_;  // shapes of the multiplied matrices, by their types
};

// Returns "float" for float4x4; empty for other identifiers and for integer matrices.
std::string_view scalar_of_matrix(std::string_view word) {
  if (word.size() < 7 || word[word.size() - 2] != 'x') return {};  // nearly all identifiers
  for (const std::string_view scalar :
       {std::string_view("float"), std::string_view("half"), std::string_view("double"),
        std::string_view("min16float"), std::string_view("min10float")}) {
    if (word.substr(0, scalar.size()) != scalar || word.size() != scalar.size() + 3) continue;
    const std::string_view shape = word.substr(scalar.size());
    const auto size = [](char c) { return c >= '1' && c <= '4'; };
    if (size(shape[0]) && shape[1] == 'x' && size(shape[2])) return scalar;
  }
  return {};
}

bool is_whole_number(std::string_view number) {
  const bool hexadecimal = number.size() > 1 && (number[1] == 'x' || number[1] == 'X');
  return hexadecimal || number.find_first_not_of("0123456789uUlL") == std::string_view::npos;
}

bool is_whole_scalar(std::string_view type) {
  return type == "int" || type == "uint" || type == "bool" || type == "dword";
}

// Returns the token after the integer literal with its sign, or the name of an integer, that begins here;
// npos for anything else.
std::size_t end_of_scalar(const TokenText& text, std::size_t at) {
  while (text.is_any(at, "-", "+")) ++at;
  if (at >= text.size()) return npos;
  const hlsl::Token& token = text[at];
  if (token.kind == hlsl::Token::Kind::number) return is_whole_number(token.spelling) ? at + 1 : npos;
  if (token.spelling == "true" || token.spelling == "false") return at + 1;
  if (token.kind != hlsl::Token::Kind::identifier || text.is_any(at + 1, "(", ".", "[")) return npos;
  const ValueType& type = text.types().at(at);
  return is_whole_scalar(type.name) && type.dimensions == 0 ? at + 1 : npos;
}

}  // namespace

void write_out_matrix_operators(TokenText& text) {
  MatrixOperators(text).run();
}

// An integer or bool cast to a float matrix, `(float4x4)0` and `float3x3(1)`. glslang 12 folds the conversion
// and silently leaves every element but the first few uninitialised: their values differ between runs. The
// number is cast to float first, `(float4x4)(float)0`, which is folded correctly.
//
// Applies to literals with their sign, true and false, and names of scalars; glslang converts run-time values
// correctly.
void widen_matrix_casts(TokenText& text) {
  for (std::size_t at = 1; at + 2 < text.size(); ++at) {
    const std::string_view scalar =
        text.is_identifier(at) ? scalar_of_matrix(text.word(at)) : std::string_view{};
    if (scalar.empty()) continue;
    const bool cast = text.is(at - 1, "(") && text.is(at + 1, ")");
    const bool constructor = text.is(at + 1, "(");
    const std::size_t end = cast || constructor ? end_of_scalar(text, at + 2) : npos;
    if (end == npos || (constructor && !text.is(end, ")"))) continue;
    text.insert(at + 2, "(" + std::string(scalar) + ")");
  }
  text.apply();
}

}  // namespace penumbra::preparation
