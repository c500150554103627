// Arrays whose initialiser is one flat list, `float2 a[2] = { 1, 2, 3, 4 };` and `float b[2][3] = { 1, 2, 3,
// 4, 5, 6
// };`: HLSL fills the components in their order; glslang wants one element of the list for each element of
// the array. Where the sizes are written as numbers and the list has exactly as many elements as there are
// components, braces are put around those of each array element.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void group_flat_initialisers(TokenText& text);

}  // namespace penumbra::preparation
