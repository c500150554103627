// Reads of textures that glslang cannot follow to the texture.
//
// - By a comparison sampler, where the texture is a parameter, a local variable or a member of a struct and
// is
//   read otherwise too: glslang makes two variables of it and sets only one; the other reads are lost without
//   a word (tools/programs/shaders/lost_resources.h finds such modules).
// - Of a texture in a struct that is a member itself, an element of an array or what a function returned,
//   `Build(a).map.Sample(s, uv)`: "unable to find texture symbol".
//
// Such a read is put into a function of its own at the head of the text, one for each kind of texture and
// read, which gets the texture as its parameter and does nothing else: `Sample_of(Build(a).map, s, uv)`.
//
// Limits: reads with an offset stay where they are, as the offset has to be a literal; so do compare-gathers.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void separate_texture_reads(TokenText& text);

}  // namespace penumbra::preparation
