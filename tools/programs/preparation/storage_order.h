// `const static uint N = 4;`: the order of the two words means nothing in HLSL
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-variable-syntax), but to glslang the later
// one counts alone, and a variable that is not constant cannot be an array's size. `static` comes first.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void put_static_first(TokenText& text);

}  // namespace penumbra::preparation
