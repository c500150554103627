// Zero cast to an array, `(float3[4])0`, which glslang parses as a constructor with too few arguments. It
// becomes the member of a zeroed struct that contains such an array, `((penumbra_zeroes0)0).value`. The
// struct is inserted before the first function that uses it.
//
// Only a literal zero is rewritten: other casts to arrays remain errors.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void cast_zero_to_structs(TokenText& text);

}  // namespace penumbra::preparation
