// Texture reads for which glslang cannot resolve the texture.
//
// - With a comparison sampler, if the texture is a parameter, a local variable or a member of a struct and is
//   also read otherwise: glslang creates two variables and sets only one; the other reads are silently lost
//   (tools/programs/shaders/lost_resources.h detects such modules).
// - Of a texture in a nested struct, in an array element or in a function's result, `Build(a).map.Sample(s,
//   uv)`: "unable to find texture symbol".
//
// Such a read is moved into a function at the beginning of the text, one for each kind of texture and read,
// with the texture as its parameter: `Sample_of(Build(a).map, s, uv)`.
//
// Limits: reads with an offset are not changed, because the offset has to be a literal; nor are
// compare-gathers.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void separate_texture_reads(TokenText& text);

}  // namespace penumbra::preparation
