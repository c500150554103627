// `const static uint N = 4;`: the order of the two keywords has no meaning in HLSL
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-variable-syntax), but glslang only regards
// the later one, and a variable that is not constant cannot be an array's size. `static` is moved to the
// front.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void put_static_first(TokenText& text);

}  // namespace penumbra::preparation
