// The minus of a bool, `-(a > b)` and `-flag`, which is 0 or -1 as of the int that the bool becomes
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-operators, unary operators); glslang stops
// at "Expected expression". It becomes `(-1 * (a > b))`.
//
// What is a bool is seen by the comparison, && or || that parentheses hold, by a !, and by the type of a
// variable, member or function (value_types.h).
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void multiply_bool_signs(TokenText& text);

}  // namespace penumbra::preparation
