#include "preparation/row_matrices.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "preparation/declarators.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

struct RowMatrix {
  std::string vector;  // the type it becomes
  bool row = false;    // has one row; else one column
  bool scalar = false;
};

std::optional<RowMatrix> row_matrix(std::string_view type) {
  if (type.size() < 6 || type[type.size() - 2] != 'x' || !is_number_type(type)) return std::nullopt;
  const char rows = type[type.size() - 3];
  const char columns = type.back();
  if (rows != '1' && columns != '1') return std::nullopt;
  std::string vector(type.substr(0, type.size() - 3));
  if (rows != columns) vector += rows == '1' ? columns : rows;
  return RowMatrix{vector, rows == '1', rows == columns};
}

class RowMatrices {
 public:
  explicit RowMatrices(TokenText& text) : text_(text), types_(text.types()) {}

  void run() {
    bool any = false;
    for (std::size_t at = 0; at < text_.size(); ++at)
      if (text_.is_identifier(at) && row_matrix(text_[at].spelling)) {
        text_.replace(at, 1, row_matrix(text_[at].spelling)->vector);
        any = true;
      }
    if (!any) return;
    refuse_uniforms();
    for (std::size_t at = 0; at + 1 < text_.size(); ++at) {
      const std::optional<RowMatrix> used = row_matrix(types_.at(at).name);
      if (used && !is_declared_here(at) && types_.at(at).dimensions == 0) rewrite_use(at, *used);
      if (!used && text_.is(at, ")") && text_.is(at + 1, "[")) refuse_unknown(at);
      if (text_.is(at, "mul") && text_.is(at + 1, "(")) check_product(at);
    }
    text_.apply();
  }

 private:
  bool is_declared_here(std::size_t at) const {
    const std::size_t index = types_.named(at);
    return index != npos && types_.declared()[index].name == at;
  }

  // Returns whether it is a row matrix itself or a struct with such a member.
  bool holds_row_matrix(std::string_view type) const {
    const auto known = types_.structs().find(type);
    if (known == types_.structs().end()) return row_matrix(type).has_value();
    return std::any_of(
        known->second.members.begin(), known->second.members.end(),
        [this](std::size_t member) { return row_matrix(types_.declared()[member].type.name).has_value(); });
  }

  void refuse_uniforms() {
    for (const DeclaredValue& value : types_.declared()) {
      if (value.place != DeclaredValue::Place::global || value.is_static || value.name == npos) continue;
      if (holds_row_matrix(value.type.name))
        text_.note(value.name, hlsl::Severity::error,
                   "'" + std::string(text_[value.name].spelling) +
                       "' is or contains a matrix with one row or one column in a constant buffer; declare a "
                       "vector");
    }
  }

  // Refuses a subscript of an expression that may be such a matrix: it is unknown whether it selects a row or
  // a component of the vector.
  void refuse_unknown(std::size_t close) {
    for (std::size_t at = text_.matching_bracket(close); at != npos && at < close; ++at) {
      if (!row_matrix(text_[at].spelling) && !row_matrix(types_.at(at).name)) continue;
      text_.note(close, hlsl::Severity::error,
                 "a subscript of an expression whose type is a matrix with one row or one column; assign it "
                 "to a variable first");
      return;
    }
  }

  // Rewrites m[0][2] to m[2] for a row, m[2][0] to m[2] for a column, and m._m02 to m.z.
  void rewrite_use(std::size_t at, const RowMatrix& type) {
    const std::size_t first = at + 1;
    if (text_.is(first, ".") && text_.is_identifier(first + 1)) {
      const std::string swizzle = components_of(text_[first + 1].spelling, type.row);
      if (!swizzle.empty()) text_.replace(first + 1, 1, swizzle);
      return;
    }
    if (!text_.is(first, "[") || text_.matching_bracket(first) == npos) return;
    const std::size_t second = text_.matching_bracket(first) + 1;
    const bool two = text_.is(second, "[") && text_.matching_bracket(second) != npos;
    if (type.scalar) {
      text_.erase(first, (two ? text_.matching_bracket(second) + 1 : second) - first);
    } else if (type.row) {
      text_.erase(first, second - first);
    } else if (two) {
      text_.erase(second, text_.matching_bracket(second) - second + 1);
    }
  }

  // Turns "_m00_m02" or "_11_13" into "xz"; returns an empty text for something else.
  static std::string components_of(std::string_view names, bool row) {
    std::string components;
    while (!names.empty()) {
      const bool from_zero = names.starts_with("_m");
      const std::size_t digits = from_zero ? 2 : 1;
      if (names[0] != '_' || names.size() < digits + 2) return {};
      const int number = names[digits + (row ? 1 : 0)] - (from_zero ? '0' : '1');
      if (number < 0 || number > 3) return {};
      components += "xyzw"[number];
      names.remove_prefix(digits + 2);
    }
    return components;
  }

  void check_product(std::size_t at) {
    const std::size_t close = text_.matching_bracket(at + 1);
    if (close == npos) return;
    std::size_t comma = at + 2;
    while (comma < close && !text_.is(comma, ",")) comma = after_brackets(text_, comma);
    const std::optional<RowMatrix> left = argument(at + 2, comma);
    const std::optional<RowMatrix> right = argument(comma + 1, close);
    const bool outer = left && right && !left->row && right->row;
    if (outer)
      text_.note(at, hlsl::Severity::error,
                 "mul() of a column vector and a row vector is their outer product, which glslang cannot "
                 "express here; write each of its rows as a component of the column times the row");
  }

  std::optional<RowMatrix> argument(std::size_t first, std::size_t end) const {
    if (first >= end) return std::nullopt;
    const std::optional<RowMatrix> constructed =
        text_.is_identifier(first) ? row_matrix(text_[first].spelling) : std::nullopt;
    if (constructed) return constructed;
    return types_.begin(end - 1) == first ? row_matrix(types_.at(end - 1).name) : std::nullopt;
  }

  TokenText& text_;
  const ValueTypes& types_;
};

}  // namespace

void make_row_matrices_vectors(TokenText& text) {
  RowMatrices(text).run();
}

}  // namespace penumbra::preparation
