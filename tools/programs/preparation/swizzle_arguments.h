// Several elements of a matrix given to an out or inout parameter, `Rotate(m._14_24_34);`, which ends
// glslang's process. They are given by way of a variable, `{ float3 v = m._14_24_34; Rotate(v); m._14_24_34 =
// v; }`, and the pass after this one writes the elements out.
//
// Statements that are a call and nothing else; the matrix must not hold a call, ++ or --, for it is named
// twice.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void pass_swizzles_in_variables(TokenText& text);

}  // namespace penumbra::preparation
