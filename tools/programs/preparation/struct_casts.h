// A struct cast to another with the same members, `(Attributes)input`, which HLSL does member by member
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-operators, casts) and glslang parses as a
// constructor with too few arguments. It becomes a call of a function that copies the members in order; a
// cast to the struct's own type is removed.
//
// The members must agree one by one: the same types, or numeric types of the same shape, and the same array
// sizes. The type of the cast expression must be known (value_types.h). Others are not changed, and remain
// errors.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void copy_cast_structs(TokenText& text);

}  // namespace penumbra::preparation
