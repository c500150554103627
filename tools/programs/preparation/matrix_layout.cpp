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

}  // namespace

// `#pragma pack_matrix(row_major)`
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-appendix-pre-pragma-pack-matrix), which
// sets the layout of the following matrices in buffers. Each declaration of a matrix at file scope, in a
// cbuffer or in a struct without a row_major or column_major of its own gets row_major;
// StructuredBuffer<float4x4>, for which glslang accepts none, is an error.
void pack_matrices(TokenText& text) {
  MatrixPacking(text).run();
}

}  // namespace penumbra::preparation
