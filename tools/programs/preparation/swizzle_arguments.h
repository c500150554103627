// A matrix swizzle passed to an out or inout parameter, `Rotate(m._14_24_34);`, which crashes glslang. It is
// passed in a temporary variable, `{ float3 v = m._14_24_34; Rotate(v); m._14_24_34 = v; }`, and the next
// pass expands the swizzles.
//
// Only for statements that consist of a call; the matrix must not contain a call, ++ or --, because it is
// evaluated twice.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void pass_swizzles_in_variables(TokenText& text);

}  // namespace penumbra::preparation
