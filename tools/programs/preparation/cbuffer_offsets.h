// Members of a cbuffer that share the last register of the member before them
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-packing-rules): matrices, arrays and
// structs begin at a register of four words and end with their last component, so g of `float3x3 m; float g;`
// is at word 11. glslang places g after whole registers. In such a cbuffer every member gets a packoffset.
//
// A cbuffer with a packoffset or a type of unknown size is not changed; a member of a struct in it that would
// have to move is an error.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void place_cbuffer_members(TokenText& text);

}  // namespace penumbra::preparation
