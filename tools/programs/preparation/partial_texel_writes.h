// Writes to some components of a texel, `_Result[id].xy += v;` or `_Result[uint2(x, y)][1] = v;`: glslang
// stops at "unimplemented: partial image updates". The statement becomes a block that reads the texel,
// changes it and writes it back, which is what the hardware does as well. An index with a call, ++ or -- is
// worked out once, into a variable. Textures and buffers of the file scope only; a component that is an
// argument for an out parameter stays an error.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_whole_texels(TokenText& text);

}  // namespace penumbra::preparation
