// Calls of intrinsics that glslang turns into SPIR-V its own validator refuses:
//
// - mad(a, b, c) of whole numbers becomes an instruction for floats: written out as ((a) * (b) + (c)), which
// HLSL
//   allows for every mad (docs "mad": precise or not is the implementation's choice).
// - ldexp(x, e) with a float e becomes Ldexp, which takes whole exponents: written out as ((x) * exp2(e)),
// HLSL's own
//   definition.
// - The values of a byte address buffer's Interlocked methods are uint: an int literal is given as uint.
// A function of the text with the name of the intrinsic is left alone.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_intrinsic_calls(TokenText& text);

}  // namespace penumbra::preparation
