// Zero cast to an array, `(float3[4])0`, which glslang takes for a constructor with too few arguments. It
// becomes the member of a zeroed struct that holds such an array, `((penumbra_zeroes0)0).value`, and the
// struct stands before the function that is the first to use it.
//
// Zero alone, written as a number: other casts to arrays stay as they are, and stay an error.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void cast_zero_to_structs(TokenText& text);

}  // namespace penumbra::preparation
