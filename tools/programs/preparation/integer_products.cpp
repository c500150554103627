#include "preparation/integer_products.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "preparation/expression_reader.h"

namespace penumbra::preparation {

namespace {

using Base = NumberShape::Base;

constexpr std::string_view kProduct = "penumbra_product";

bool is_integer_matrix(const NumberShape& shape) {
  return shape.is_matrix() && (shape.base == Base::integer || shape.base == Base::natural);
}

std::string sum_of_products(const NumberShape& a, const NumberShape& b, int row, int column, Base base) {
  const std::string type = type_of_shape({base});
  const int common = std::min(a.columns, b.is_matrix() ? b.rows : b.columns);
  std::string sum;
  for (int i = 0; i < common; ++i) {
    const std::string at = "[" + std::to_string(i) + "]";
    const std::string left = a.is_matrix() ? "a[" + std::to_string(row) + "]" + at : "a" + at;
    const std::string right = b.is_matrix() ? "b" + at + "[" + std::to_string(column) + "]" : "b" + at;
    sum += (i == 0 ? "" : " + ") + type + "(" + left + ") * " + type + "(" + right + ")";
  }
  return sum;
}

std::string definition(const NumberShape& a, const NumberShape& b) {
  const Base base = std::max(a.base, b.base);
  const int rows = a.is_matrix() ? a.rows : 1;
  const int columns = b.is_matrix() ? b.columns : 1;
  const bool matrix = a.is_matrix() && b.is_matrix();
  const std::string type =
      type_of_shape(matrix ? NumberShape{base, rows, columns} : NumberShape{base, 0, rows * columns});
  std::string elements;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      elements += (elements.empty() ? "" : ", ") + sum_of_products(a, b, row, column, base);
  return type + " " + std::string(kProduct) + "(" + type_of_shape(a) + " a, " + type_of_shape(b) +
         " b) { return " + type + "(" + elements + "); }\n";
}

class IntegerProducts final : public ExpressionReader {
 public:
  explicit IntegerProducts(TokenText& text) : ExpressionReader(text), text_(text) {}

  void write() {
    std::string all;
    for (const auto& [types, text] : definitions_) all += text;
    if (!all.empty()) text_.insert(0, all);
    text_.apply();
  }

 private:
  void read_binary(const ReadOperand&, std::size_t, const ReadOperand&) override {}
  void read_intrinsic(std::size_t name, const std::vector<NumberShape>& arguments) override {
    if (!text_.is(name, "mul") || arguments.size() != 2) return;
    const NumberShape& a = arguments[0];
    const NumberShape& b = arguments[1];
    if ((!is_integer_matrix(a) && !is_integer_matrix(b)) || a.columns < 2 || b.columns < 2) return;
    definitions_.emplace(std::pair(type_of_shape(a), type_of_shape(b)), definition(a, b));
    text_.replace(name, 1, kProduct);
  }

  TokenText& text_;
  std::map<std::pair<std::string, std::string>, std::string> definitions_;
};

bool has_integer_matrix(const TokenText& text) {
  const auto& tokens = text.tokens();
  return std::any_of(tokens.begin(), tokens.end(), [](const hlsl::Token& token) {
    return (token.spelling.starts_with("int") || token.spelling.starts_with("uint") ||
            token.spelling.starts_with("min1")) &&
           is_integer_matrix(shape_of_type(token.spelling));
  });
}

}  // namespace

void write_out_integer_products(TokenText& text) {
  if (!has_integer_matrix(text)) return;
  IntegerProducts products(text);
  products.read_all();
  products.write();
}

}  // namespace penumbra::preparation
