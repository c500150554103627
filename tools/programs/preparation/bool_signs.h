// Unary minus of a bool, `-(a > b)` and `-flag`, which is 0 or -1, because the bool is promoted to int
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-operators, unary operators); glslang
// reports "Expected expression". It becomes `(-1 * (a > b))`.
//
// An operand is recognised as a bool by a comparison, && or || within its parentheses, by a !, and by the
// type of a variable, member or function (value_types.h).
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void multiply_bool_signs(TokenText& text);

}  // namespace penumbra::preparation
