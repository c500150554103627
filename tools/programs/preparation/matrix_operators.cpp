#include "preparation/matrix_operators.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "preparation/expression_reader.h"
#include "preparation/postfix_expression.h"

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
    text_.note(op, hlsl::Severity::error,
               "'*' does not combine a vector with a matrix; mul() is the product of linear algebra");
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

}  // namespace

void write_out_matrix_operators(TokenText& text) {
  MatrixOperators(text).run();
}

}  // namespace penumbra::preparation
