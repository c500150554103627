// Textures, samplers and buffers declared among the members of a cbuffer or tbuffer. In HLSL they take no
// part in its layout and are resources like those at file scope; glslang makes them members of the block,
// which no Vulkan driver takes. They are moved before the cbuffer, with their register() and on their own
// line; a cbuffer that held nothing else goes.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void hoist_cbuffer_resources(TokenText& text);

}  // namespace penumbra::preparation
