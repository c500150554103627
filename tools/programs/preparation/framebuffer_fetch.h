// Shaders that read the pixel they are about to write.
//
// Unity has two ways to say so, and on Vulkan both mean an input attachment of the subpass:
// - `cbuffer hlslcc_SubpassInput_f_2 { float4 name; }`, which its compiler knows by that name: f, h, i and u
//   are float4, half4, int4 and uint4, the capital letters the same with several samples, `name[8]`; the
//   number is that of the attachment. Shader libraries write it by FRAMEBUFFER_INPUT_FLOAT(2) and the like.
// - a fragment function's `inout half4 color : SV_Target1` (Unity manual, SL-PlatformDifferences, "Using
//   shader framebuffer fetch"). To glslang that is an input from the vertex stage and an output, two things.
//
// The first becomes a SubpassInput of that number, and what names it, `.SubpassLoad()`. The second becomes an
// `out` parameter that is loaded at the function's start; only of functions that nothing in the text calls.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void read_framebuffer(TokenText& text);

}  // namespace penumbra::preparation
