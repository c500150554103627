// The shape of a numeric type - scalar, vector or matrix, and its base type - and the result shapes of HLSL's
// operators. Internal to this folder.
#pragma once

#include <string>
#include <string_view>

namespace penumbra::preparation {

struct NumberShape {
  enum class Base { unknown, boolean, integer, natural, real };  // in the order of promotion
  Base base = Base::unknown;
  int rows = 0;     // of a matrix; 0 otherwise
  int columns = 0;  // of a matrix or vector; 0: a scalar

  bool known() const { return base != Base::unknown; }
  bool is_matrix() const { return known() && rows > 0; }
  bool is_vector() const { return known() && rows == 0 && columns > 0; }
  bool is_scalar() const { return known() && columns == 0; }
  bool operator==(const NumberShape&) const = default;

  NumberShape of_base(Base other) const { return {known() ? other : base, rows, columns}; }
};

NumberShape shape_of_type(std::string_view type);      // of "half3x4", ...; unknown for other identifiers
NumberShape shape_of_number(std::string_view number);  // of 1.5h, 12u, 0xF; a suffix L does not count
std::string type_of_shape(const NumberShape& shape);   // of a known one; half is float

// The shape of an arithmetic operator's result: the higher base type, the smaller shape, where a scalar is
// extended to any shape. Unknown if one is unknown, and for a vector with a matrix, which HLSL does not
// combine.
NumberShape combined_shape(const NumberShape& a, const NumberShape& b);

}  // namespace penumbra::preparation
