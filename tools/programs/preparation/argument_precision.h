// HLSL's view of a call's argument as half or as float, for overloads that differ only in precision. Internal
// to this folder.
#pragma once

#include <cstddef>
#include <vector>

#include "preparation/token_text.h"

namespace penumbra::preparation {

enum class Precision { full, narrow };

// Returns whether the type is half2, min16float, min10float3x3, min16int or similar.
bool is_narrow_type(std::string_view type);

// Returns one result for each argument in the parentheses that open at `open`: narrow if it has variables,
// casts or calls and all of them are narrow; literals alone are full.
std::vector<Precision> argument_precisions(const TokenText& text, std::size_t open);

}  // namespace penumbra::preparation
