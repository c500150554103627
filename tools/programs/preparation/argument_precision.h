// Whether HLSL takes the argument of a call for a half or for a float, where two functions differ in that
// alone. Internal to this room.
#pragma once

#include <cstddef>
#include <vector>

#include "preparation/token_text.h"

namespace penumbra::preparation {

enum class Precision { full, narrow };

// half2, min16float, min10float3x3, min16int, ...
bool is_narrow_type(std::string_view type);

// Of each argument in the parentheses that open here: narrow where all its variables, casts and calls are,
// and there is one; numbers alone are full.
std::vector<Precision> argument_precisions(const TokenText& text, std::size_t open);

}  // namespace penumbra::preparation
