// Textures, samplers, buffers and static variables that are declared in a cbuffer or tbuffer. In HLSL they
// are not part of its layout, but equivalent to declarations at file scope; glslang makes them members of the
// block: no Vulkan driver accepts the resources, and a static constant silently loses its value. They are
// moved before the cbuffer, with their register() and their line; a cbuffer without other members is removed.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void hoist_cbuffer_resources(TokenText& text);

}  // namespace penumbra::preparation
