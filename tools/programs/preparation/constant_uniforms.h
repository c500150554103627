// `const float k = 5;` at file scope, without static: a uniform in HLSL
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-variable-syntax, "extern"), whose
// initialiser is a default that Unity ignores, so that it is 0 unless something sets it. glslang takes it for
// a constant. `const` and initialiser go, with a warning; where the size of an array needs the value, it
// stands there.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void make_constants_uniforms(TokenText& text);

}  // namespace penumbra::preparation
