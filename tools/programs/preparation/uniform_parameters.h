// `float F(float a, uniform float b)`: in functions that the entry point calls, `uniform` has no effect in
// HLSL. glslang does not convert the arguments of such parameters: `F(x, 2)` becomes SPIR-V that does not
// validate.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void drop_uniform_of_parameters(TokenText& text);

}  // namespace penumbra::preparation
