// Arrays with a flat initialiser list, `float2 a[2] = { 1, 2, 3, 4 };` and `float b[2][3] = { 1, 2, 3, 4, 5,
// 6 };`: HLSL fills the components in order; glslang expects one list element per array element. If the sizes
// are literals and the list has exactly one element per component, braces are put around those of each array
// element.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void group_flat_initialisers(TokenText& text);

}  // namespace penumbra::preparation
