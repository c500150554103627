// A declaration such as `const float k = 5;` at file scope, without static, is a uniform in HLSL
// (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-variable-syntax, "extern"). Its
// initialiser is a default that Unity ignores, so it is 0 unless something sets it. glslang treats it as a
// constant. `const` and the initialiser are removed, with a warning; array sizes that use the constant get
// its value.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void make_constants_uniforms(TokenText& text);

}  // namespace penumbra::preparation
