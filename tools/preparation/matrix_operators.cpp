#include "preparation/matrix_operators.h"

#include <set>
#include <string>
#include <string_view>
#include <unordered_map>

#include "preparation/declarators.h"
#include "preparation/postfix_expression.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

constexpr std::string_view product_function = "penumbra_times";

// "4x3" of float4x3; empty for all but matrices of floats.
std::string_view matrix_shape(std::string_view type) {
  const bool matrix = type.size() > 3 && type[type.size() - 2] == 'x' && is_number_type(type) &&
                      (type[0] == 'f' || type[0] == 'h');
  return matrix ? type.substr(type.size() - 3) : std::string_view{};
}

bool is_multiplication(const TokenText& text, std::size_t at) {
  return text.is(at, "*") || text.is(at, "/") || text.is(at, "%");
}

// Each of the four is a token of its own.
bool is_arithmetic(const TokenText& text, std::size_t at) {
  const char mark = text.lead(at);
  return mark == '*' || mark == '/' || mark == '+' || mark == '-';
}

bool ends_operand(const TokenText& text, std::size_t at) {
  return text.is_word(at) || text[at].kind == hlsl::Token::Kind::number || text.is(at, ")") ||
         text.is(at, "]");
}

// (float3x3) and the like from this '('.
bool is_cast(const TokenText& text, std::size_t open) {
  return text.is(open, "(") && text.is_word(open + 1) && is_number_type(text[open + 1].spelling) &&
         text.is(open + 2, ")");
}

// What stands beside an operator.
struct Operand {
  std::size_t begin = npos;
  std::size_t end = npos;     // one past it
  std::string_view matrix{};  // its type when that is known to be a matrix
  bool scalar = false;        // known to be none
};

class MatrixOperators {
 public:
  explicit MatrixOperators(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    for (std::size_t at = 1; at + 1 < text_.size(); ++at) {
      if (!is_arithmetic(text_, at) || !ends_operand(text_, at - 1)) continue;
      if (assignment_length(text_, at) == 2) {
        assignment(at);
      } else {
        combination(at);
      }
    }
    std::string functions;
    for (const std::string_view shape : shapes_) functions += definitions(shape);
    if (!functions.empty()) text_.insert(0, functions);
    text_.apply();
  }

 private:
  std::string_view word(std::size_t at) const { return text_[at].spelling; }

  void combination(std::size_t at) {
    const Operand right = operand_from(at + 1);
    const Operand left = operand_until(at);
    if (right.end == npos || left.begin == npos || (left.matrix.empty() && right.matrix.empty())) return;
    if (left.scalar || right.scalar) return;
    const std::size_t begin = text_.is(at, "*") ? product_begin(at, left.begin) : npos;
    if (begin != npos) {
      remember(left, right);
      text_.insert(begin, std::string(product_function) + "(");
      text_.replace(at, 1, ",");
    }
    cast_the_larger(left, right);
    if (begin != npos) text_.insert(right.end, ")");
  }

  // m *= n;  ->  m = penumbra_times(m, n);
  void assignment(std::size_t at) {
    if (!text_.is(at, "*")) return;
    const Operand left = operand_until(at);
    const Operand right = operand_from(at + 2);
    const std::size_t end = expression_end(text_, at + 2);
    const bool by_scalar = right.scalar && right.end == end;
    if (left.matrix.empty() || by_scalar || !begins_statement(text_, left.begin)) return;
    if (end == npos || !text_.is(end, ";") || !may_be_repeated(text_, left.begin, left.end)) return;
    remember(left, right);
    text_.replace(
        at, 2, "= " + std::string(product_function) + "(" + text_.spelled(left.begin, at - left.begin) + ",");
    text_.insert(end, ")");
  }

  void cast_the_larger(const Operand& left, const Operand& right) {
    const std::string_view a = matrix_shape(left.matrix);
    const std::string_view b = matrix_shape(right.matrix);
    if (a.empty() || b.empty() || a == b) return;
    if (a[0] <= b[0] && a[2] <= b[2]) {
      text_.insert(right.begin, "(" + std::string(left.matrix) + ")");
    } else if (b[0] <= a[0] && b[2] <= a[2]) {
      text_.insert(left.begin, "(" + std::string(right.matrix) + ")");
    }
  }

  void remember(const Operand& left, const Operand& right) {
    if (!left.matrix.empty()) shapes_.insert(matrix_shape(left.matrix));
    if (!right.matrix.empty()) shapes_.insert(matrix_shape(right.matrix));
  }

  // The type of the postfix expression [begin, end).
  void find_type(Operand& operand) {
    const std::size_t last = operand.end - 1;
    if (text_[last].kind == hlsl::Token::Kind::number) {
      operand.scalar = true;
      return;
    }
    if (text_.is(operand.begin, "(") && text_.partner(operand.begin) == last) {
      operand.matrix = group_type(operand.begin);
    } else if (text_.is(operand.begin + 1, "(") && text_.partner(operand.begin + 1) == last) {
      operand.matrix = call_type(operand.begin);
    }
    if (operand.matrix.empty()) from_values(operand);
  }

  // float3x3(...), transpose(m) and mul(m, n); of the latter two those of square matrices.
  std::string_view call_type(std::size_t name) {
    if (!matrix_shape(word(name)).empty()) return word(name);
    const bool product = text_.is(name, "mul");
    if (!product && !text_.is(name, "transpose")) return {};
    const std::string_view type = group_type(name + 1);
    const std::string_view shape = matrix_shape(type);
    return !shape.empty() && shape[0] == shape[2] ? type : std::string_view{};
  }

  // Of the matrices that `(a + b * c)` combines, or of all the arguments of `(a, b)` if all are matrices
  // alike.
  std::string_view group_type(std::size_t open) {
    constexpr int deepest = 64;  // keeps the time linear: a group is read again for each group around it
    if (depth_ == deepest) return {};
    ++depth_;
    const std::string_view type = read_group(open + 1, text_.partner(open));
    --depth_;
    return type;
  }

  std::string_view read_group(std::size_t at, std::size_t end) {
    std::string_view found;
    std::string_view before;  // of the arguments before this one
    while (at < end) {
      const Operand operand = operand_from(at);
      if (operand.end == npos) return {};
      if (!operand.matrix.empty()) found = operand.matrix;
      at = operand.end;
      if (at == end || text_.is(at, ",")) {
        if (found.empty() || (!before.empty() && matrix_shape(before) != matrix_shape(found))) return {};
        before = found;
        found = {};
      } else if (!is_arithmetic(text_, at)) {
        return {};
      }
      ++at;
    }
    return before;
  }

  void from_values(Operand& operand) const {
    const std::size_t last = operand.end - 1;
    if (types_.begin(last) != operand.begin) return;
    const ValueType& type = types_.at(last);
    if (type.dimensions > 0 || !is_number_type(type.name)) return;
    if (!matrix_shape(type.name).empty()) {
      operand.matrix = type.name;
    } else {
      operand.scalar = true;
    }
  }

  // Signs, casts and a postfix expression from `begin`.
  Operand operand_from(std::size_t begin) {
    Operand operand{begin, npos};
    std::size_t at = begin;
    std::string_view cast;
    while (text_.is(at, "-") || text_.is(at, "+") || is_cast(text_, at)) {
      if (is_cast(text_, at) && cast.empty()) cast = word(at + 1);
      at += is_cast(text_, at) ? 3 : 1;
    }
    const bool group = text_.is(at, "(") && text_.partner(at) != npos;
    if (at >= text_.size() || !(ends_operand(text_, at) || group)) return operand;
    const std::size_t first_end = group ? text_.partner(at) : at;
    Operand inner{at, postfix_end(text_, first_end)};
    find_type(inner);
    operand.end = inner.end;
    set_type(operand, inner, cast);
    return operand;
  }

  // The same, that ends before the operator `end`.
  Operand operand_until(std::size_t end) {
    Operand operand{npos, end};
    const bool number = text_[end - 1].kind == hlsl::Token::Kind::number;
    const std::size_t begin = number ? end - 1 : postfix_begin(text_, end - 1);
    if (begin == npos) return operand;
    Operand inner{begin, end};
    find_type(inner);
    std::size_t first = begin;
    std::string_view cast;
    while (first >= 3 && is_cast(text_, first - 3)) {
      cast = word(first - 2);
      first -= 3;
    }
    operand.begin = first;
    set_type(operand, inner, cast);
    return operand;
  }

  static void set_type(Operand& operand, const Operand& inner, std::string_view cast) {
    operand.matrix = cast.empty() ? inner.matrix : std::string_view{};
    operand.scalar = cast.empty() && inner.scalar;
    if (cast.empty()) return;
    if (!matrix_shape(cast).empty()) {
      operand.matrix = cast;
    } else {
      operand.scalar = true;
    }
  }

  // Of the product that the operator at `mark` ends with its right factor: x / m * n is (x / m) * n. Products
  // are met from left to right, and what an operator before found is used again.
  std::size_t product_begin(std::size_t mark, std::size_t left) {
    std::size_t begin = left;
    while (begin != npos && begin > 0 && is_multiplication(text_, begin - 1)) {
      const auto known = products_.find(begin - 1);
      begin = known != products_.end() ? known->second : operand_until(begin - 1).begin;
      if (known != products_.end()) break;
    }
    products_[mark] = begin;
    return begin;
  }

  // Row by row, and by a scalar on either side.
  static std::string definitions(std::string_view shape) {
    const std::string type = "float" + std::string(shape);
    const std::string head = type + " " + std::string(product_function) + "(";
    std::string rows;
    for (char row = '0'; row < shape[0]; ++row) {
      const std::string i = std::string("[") + row + "]";
      rows.append(rows.empty() ? "" : ", ").append("a").append(i).append(" * b").append(i);
    }
    return head + type + " a, " + type + " b) { return " + type + "(" + rows + "); } " + head + type +
           " a, float b) { return a * b; } " + head + "float a, " + type + " b) { return a * b; }\n";
  }

  TokenText& text_;
  const ValueTypes& types_;
  std::set<std::string_view> shapes_;
  std::unordered_map<std::size_t, std::size_t>
      products_;  // where those that are rewritten begin, by operator
  int depth_ = 0;
};

}  // namespace

void write_out_matrix_operators(TokenText& text) {
  MatrixOperators(text).run();
}

}  // namespace penumbra::preparation
