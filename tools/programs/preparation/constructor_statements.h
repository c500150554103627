// A statement that begins with a constructor, `float3(1, 2, 3);` or `half4(a) * f(b);`: HLSL evaluates and
// discards it; glslang parses the beginning of a declaration. It is put in parentheses, so calls in it are
// still executed.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void wrap_constructor_statements(TokenText& text);

}  // namespace penumbra::preparation
