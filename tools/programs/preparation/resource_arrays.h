// Local arrays of textures and samplers with an initialiser in braces, and a single one in braces: glslang
// has no constructor for them ("Missing functionality: unknown glslang aggregate", and an array full of
// nothing). The declaration loses its initialiser and is followed by one assignment for each element, which
// is the same.
//
// Where a texture is chosen by ?: and read in the same expression, which no HLSL compiler takes, glslang 12
// ends the process: that is an error here.
//
// Limits: arrays of one dimension. Static arrays keep their initialiser, which the SPIR-V back end reports.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void assign_resource_arrays(TokenText& text);

}  // namespace penumbra::preparation
