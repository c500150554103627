// Framebuffer fetch: shaders that read the pixel they are about to write.
//
// Unity has two notations, and on Vulkan both mean an input attachment of the subpass:
// - `cbuffer hlslcc_SubpassInput_f_2 { float4 name; }`, which its compiler recognises by name: f, h, i and u
//   are float4, half4, int4 and uint4, capital letters the same with multisampling, `name[8]`; the number is
//   that of the attachment. Shader libraries write it with FRAMEBUFFER_INPUT_FLOAT(2) and similar macros.
// - a fragment function's `inout half4 color : SV_Target1` (Unity manual, SL-PlatformDifferences, "Using
//   shader framebuffer fetch"). glslang treats it as an input from the vertex stage and a separate output.
//
// The first becomes a SubpassInput with that number, and its uses become `.SubpassLoad()`. The second becomes
// an `out` parameter that is loaded at the beginning of the function; only in functions that the text does
// not call.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void read_framebuffer(TokenText& text);

}  // namespace penumbra::preparation
