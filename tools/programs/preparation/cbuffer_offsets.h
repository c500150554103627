// Members of a cbuffer that lie in what the one before leaves free
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-packing-rules): matrices, arrays and
// structs begin at a register of four words and end with their last number, so that of `float3x3 m; float g;`
// g is word 11. glslang puts g behind whole registers. In such a cbuffer every member gets its packoffset.
//
// A cbuffer with a packoffset or a type of unknown size is left alone; a member of a struct in it that would
// have to move is an error.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void place_cbuffer_members(TokenText& text);

}  // namespace penumbra::preparation
