// Global variables and members of cbuffers whose struct holds textures, samplers or buffers beside numbers.
// glslang takes them apart and makes constants of the numbers that are in no block, which is not valid
// SPIR-V.
//
// `Surface s;` becomes one declaration for each member, `Texture2D s_map; float4 s_tint;`, in its place,
// followed by a function that puts a Surface together from them; where `s` was read, that function is called.
//
// Limits: in a cbuffer the members follow those before them without the struct's alignment to sixteen bytes,
// and reflection shows them by their new names. Arrays of such structs are an error.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void take_apart_uniform_structs(TokenText& text);

}  // namespace penumbra::preparation
