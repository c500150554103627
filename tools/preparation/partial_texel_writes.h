// Writes to some components of a texel, `_Result[id].xy += v;`: glslang stops at "unimplemented: partial
// image updates". The statement becomes a block that reads the texel, changes it and writes it back, which is
// what the hardware does as well. The index is repeated, so it must not hold a call, ++ or --: such a
// statement stays, and glslang says so. Textures and buffers of the file scope only.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_whole_texels(TokenText& text);

}  // namespace penumbra::preparation
