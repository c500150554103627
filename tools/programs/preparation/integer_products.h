// The function mul() of integer matrices, which glslang does not have ("no matching overloaded function"), is
// replaced by a function for each pair of types that a text multiplies. If one operand has one more row or
// column than fits the other, it is truncated, as in HLSL.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_integer_products(TokenText& text);

}  // namespace penumbra::preparation
