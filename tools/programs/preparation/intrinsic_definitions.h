// Intrinsic functions whose definitions differ between glslang and HLSL
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-intrinsic-functions), defined in the text:
//
// - sign() returns int, and 0 or 1 for an unsigned number; glslang's returns the argument's type, so sign(x)
//   / 2 is not an integer division.
// - lit()'s specular part is n.h raised to the power of m; glslang's multiplies.
//
// A function of the text with the name of the intrinsic is not changed.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void define_intrinsics(TokenText& text);

}  // namespace penumbra::preparation
