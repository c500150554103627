// `unsigned int`, `unsigned` and `unsigned int2` (learn.microsoft.com/windows/win32/direct3dhlsl/
// dx-graphics-hlsl-scalar): a reserved word to glslang. They become uint and uint2.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void name_unsigned_types(TokenText& text);

}  // namespace penumbra::preparation
