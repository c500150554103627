// A struct cast to another with the same members, `(Attributes)input`, which HLSL does member by member
// (docs.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-operators, casts) and glslang takes for a
// constructor with too few arguments. It becomes a call of a function that copies the members in their order;
// a cast to the struct's own type goes.
//
// The members must agree one by one: the same types, or numbers of one shape, and the same array sizes. The
// type of what is cast must be known (value_types.h). Others stay as they are, and stay an error.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void copy_cast_structs(TokenText& text);

}  // namespace penumbra::preparation
