// Intrinsic functions that glslang defines otherwise than HLSL
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-intrinsic-functions), defined in the text:
//
// - sign() returns int, and of an unsigned number 0 or 1; glslang's returns what it is given, so that sign(x)
// / 2 is
//   no division of whole numbers.
// - lit()'s specular part is n.h to the power of m; glslang's multiplies.
// A function of the text with the name of the intrinsic is left alone.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void define_intrinsics(TokenText& text);

}  // namespace penumbra::preparation
