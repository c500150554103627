// Global variables and members of cbuffers whose struct contains textures, samplers or buffers as well as
// numbers. glslang splits them and makes the numbers constants outside of any block, which is invalid SPIR-V.
//
// `Surface s;` becomes one declaration per member, `Texture2D s_map; float4 s_tint;`, in its place, followed
// by a function that assembles a Surface from them; reads of `s` call that function.
//
// Limits: in a cbuffer the members are not aligned to sixteen bytes as the struct is, and reflection lists
// them with their new names. Arrays of such structs are an error.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void take_apart_uniform_structs(TokenText& text);

}  // namespace penumbra::preparation
