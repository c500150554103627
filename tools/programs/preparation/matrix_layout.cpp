#include <algorithm>

#include "hlsl/declarations.h"
#include "preparation/declarators.h"
#include "preparation/declared_values.h"
#include "preparation/number_shape.h"
#include "preparation/passes.h"
#include "preparation/source_directives.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

using Kind = hlsl::Declaration::Kind;

class MatrixPacking {
 public:
  explicit MatrixPacking(TokenText& text) : text_(text) {}

  void run() {
    if (!take_markers_out()) return;
    for (const hlsl::Declaration& declaration : text_.declarations()) {
      if (declaration.kind == Kind::variable) declare(declaration.first, declaration.last);
      if (declaration.kind == Kind::alias) declare(declaration.first, declaration.last);
      if (declaration.kind == Kind::buffer || declaration.kind == Kind::structure)
        members(declaration.open, declaration.close);
    }
    text_.apply();
  }

 private:
  bool is_marker(std::size_t at) const {
    return text_.is(at, kPackedByRows) || text_.is(at, kPackedByColumns) || text_.is(at, kPackedOtherwise);
  }

  // Removes the pragmas, with those that are for FXC alone; returns true if there were any about packing. For
  // each remaining token, records the last pragma before it.
  bool take_markers_out() {
    bool rows = false;
    bool found = false;
    for (std::size_t at = 0; at < text_.size(); ++at) {
      if (text_.word(at).starts_with(kWarningPragma)) {
        text_.erase(at, text_.is(at + 1, ";") ? 2 : 1);
        if (text_.is(at + 1, ";")) ++at;
        continue;
      }
      if (!is_marker(at)) {
        by_rows_.push_back(rows);
        continue;
      }
      found = true;
      if (text_.is(at, kPackedOtherwise))
        text_.error(at, "unknown '#pragma pack_matrix'; it takes (row_major) or (column_major)");
      rows = text_.is(at, kPackedByRows);
      text_.erase(at, text_.is(at + 1, ";") ? 2 : 1);
      if (text_.is(at + 1, ";")) ++at;
    }
    text_.apply();
    return found;
  }

  void members(std::size_t open, std::size_t close) {
    std::size_t first = open + 1;
    for (std::size_t at = first; at < close; ++at) {
      if (text_.is(at, "{") && text_.matching_bracket(at) != npos) {
        const bool structure = text_.is(at - 1, "struct") || text_.is(at - 2, "struct");
        if (structure) members(at, text_.matching_bracket(at));
        at = text_.matching_bracket(at);
        first = at + 1;
      } else if (text_.is(at, ";")) {
        declare(first, at);
        first = at + 1;
      }
    }
  }

  void declare(std::size_t first, std::size_t last) {
    if (!by_rows_[first]) return;
    std::size_t type = first;
    if (text_.is(type, "typedef")) ++type;
    for (; type < last && is_modifier(text_.word(type)); ++type)
      if (text_.is_any(type, "row_major", "column_major", "static")) return;
    const bool function = text_.is_identifier(type + 1) && text_.is(type + 2, "(");
    if (function || !text_.is_identifier(type)) return;
    if (shape_of_type(text_.word(type)).is_matrix()) {
      text_.insert(type, "row_major");
    } else if (text_.is(type + 1, "<") && shape_of_type(text_.word(type + 2)).is_matrix()) {
      text_.error(type,
                  "not supported here: '" + text_.name(type) +
                      "' of matrices after '#pragma pack_matrix(row_major)'; put the matrix into a struct");
    }
  }

  TokenText& text_;
  std::vector<bool> by_rows_;  // for each token: the last pragma before it is row_major
};

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
      if (text_.is_identifier(at) && row_matrix(text_.word(at))) {
        text_.replace(at, 1, row_matrix(text_.word(at))->vector);
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
        text_.error(
            value.name,
            "'" + text_.name(value.name) +
                "' is or contains a matrix with one row or one column in a constant buffer; declare a "
                "vector");
    }
  }

  // Refuses a subscript of an expression that may be such a matrix: it is unknown whether it selects a row or
  // a component of the vector.
  void refuse_unknown(std::size_t close) {
    for (std::size_t at = text_.matching_bracket(close); at != npos && at < close; ++at) {
      if (!row_matrix(text_.word(at)) && !row_matrix(types_.at(at).name)) continue;
      text_.error(close,
                  "a subscript of an expression whose type is a matrix with one row or one column; assign it "
                  "to a variable first");
      return;
    }
  }

  // Rewrites m[0][2] to m[2] for a row, m[2][0] to m[2] for a column, and m._m02 to m.z.
  void rewrite_use(std::size_t at, const RowMatrix& type) {
    const std::size_t first = at + 1;
    if (text_.is(first, ".") && text_.is_identifier(first + 1)) {
      const std::string swizzle = components_of(text_.word(first + 1), type.row);
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
    while (comma < close && !text_.is(comma, ",")) comma = text_.after(comma);
    const std::optional<RowMatrix> left = argument(at + 2, comma);
    const std::optional<RowMatrix> right = argument(comma + 1, close);
    const bool outer = left && right && !left->row && right->row;
    if (outer)
      text_.error(at,
                  "mul() of a column vector and a row vector is their outer product, which glslang cannot "
                  "express here; write each of its rows as a component of the column times the row");
  }

  std::optional<RowMatrix> argument(std::size_t first, std::size_t end) const {
    if (first >= end) return std::nullopt;
    const std::optional<RowMatrix> constructed =
        text_.is_identifier(first) ? row_matrix(text_.word(first)) : std::nullopt;
    if (constructed) return constructed;
    return types_.begin(end - 1) == first ? row_matrix(types_.at(end - 1).name) : std::nullopt;
  }

  TokenText& text_;
  const ValueTypes& types_;
};

}  // namespace

// `#pragma pack_matrix(row_major)`
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-appendix-pre-pragma-pack-matrix), which
// sets the layout of the following matrices in buffers. Each declaration of a matrix at file scope, in a
// cbuffer or in a struct without a row_major or column_major of its own gets row_major;
// StructuredBuffer<float4x4>, for which glslang accepts none, is an error.
void pack_matrices(TokenText& text) {
  MatrixPacking(text).run();
}

// Matrices with one row or one column, float1x3 and float4x1: "Cannot construct this type" in glslang,
// because SPIR-V requires at least two columns and rows. They become vectors: `m[0][2]` and `m._m02` of a
// float1x3 become component z, `m[2]` of a float3x1 becomes a scalar, and mul() treats a vector as a row on
// its left and as a column on its right, as required.
//
// Errors: mul() of a column and a row, for which glslang would compute a scalar, and such a matrix in a
// constant buffer, where each of its columns occupies a register.
void make_row_matrices_vectors(TokenText& text) {
  RowMatrices(text).run();
}

}  // namespace penumbra::preparation
