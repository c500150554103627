// Local arrays of textures and samplers with an initialiser list, and single ones with a list: glslang has no
// constructor for them ("Missing functionality: unknown glslang aggregate", and the elements are never set).
// The declaration loses its initialiser and is followed by one assignment per element, which is equivalent.
//
// glslang 12 crashes on a texture that is selected by ?: and read in the same expression, which no HLSL
// compiler accepts: that is an error here.
//
// Limits: one-dimensional arrays. Static arrays keep their initialiser, which the SPIR-V back end reports.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void assign_resource_arrays(TokenText& text);

}  // namespace penumbra::preparation
