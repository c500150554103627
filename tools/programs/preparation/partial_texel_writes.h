// Writes to some components of a texel, `_Result[id].xy += v;` or `_Result[uint2(x, y)][1] = v;`: glslang
// reports "unimplemented: partial image updates". The statement becomes a block that reads the texel, changes
// it and writes it back, which is also what the hardware does. An index with a call, ++ or -- is evaluated
// once, into a variable. Only for textures and buffers at file scope; a component as the argument of an out
// parameter remains an error.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_whole_texels(TokenText& text);

}  // namespace penumbra::preparation
