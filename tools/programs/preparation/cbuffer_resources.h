// Textures, samplers and buffers, and static variables, declared among the members of a cbuffer or tbuffer.
// In HLSL they take no part in its layout and are what they would be at file scope; glslang makes them
// members of the block: no Vulkan driver takes the resources, and a static constant loses its value without
// an error. They are moved before the cbuffer, with their register() and on their own line; a cbuffer that
// held nothing else goes.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void hoist_cbuffer_resources(TokenText& text);

}  // namespace penumbra::preparation
