// The composition of a type: the number of its scalars and their grouping. Internal to this folder.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "preparation/value_types.h"

namespace penumbra::preparation {

struct ValueShape {
  std::string_view type;          // its name; empty for an array
  std::size_t numbers = 0;        // scalars, of all parts together
  std::vector<ValueShape> parts;  // members or elements; empty for numbers, vectors and matrices
};

// Returns 3 for float3, 16 for float4x4, 1 for float.
std::size_t components(std::string_view number_type);

// Returns nothing for resources, for array sizes that are not literals, and for types of more than 4096
// scalars.
std::optional<ValueShape> shape_of(const TokenText& text, const DeclaredValue& value);

}  // namespace penumbra::preparation
