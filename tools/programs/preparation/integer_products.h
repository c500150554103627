// mul() of matrices of integers, which glslang does not have ("no matching overloaded function"): a function
// for each pair of types that a text multiplies takes its place. What has one dimension more than the other
// loses it, as in HLSL.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_integer_products(TokenText& text);

}  // namespace penumbra::preparation
