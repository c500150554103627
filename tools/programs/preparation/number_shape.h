// The shape of a numeric type - scalar, vector or matrix, and its base type. Internal to this folder.
#pragma once

#include <string>

#include "preparation/value_types.h"

namespace penumbra::preparation {

struct NumberShape {
  enum class Base { unknown, boolean, integer, natural, real };
  Base base = Base::unknown;
  int rows = 0;     // rows of a matrix; 0 otherwise
  int columns = 0;  // columns of a matrix or vector; 0 for a scalar

  bool known() const { return base != Base::unknown; }
  bool is_matrix() const { return known() && rows > 0; }
  bool is_vector() const { return known() && rows == 0 && columns > 0; }
};

NumberShape shape_of_type(std::string_view type);      // for "half3x4", ...; unknown for other identifiers
NumberShape shape_of_number(std::string_view number);  // for 1.5h, 12u, 0xF; a suffix L does not count

// Returns 3 for float3, 16 for float4x4, 1 for float.
std::size_t components(std::string_view number_type);

}  // namespace penumbra::preparation
