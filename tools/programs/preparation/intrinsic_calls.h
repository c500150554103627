// Calls of intrinsics for which glslang emits SPIR-V that does not validate:
//
// - mad(a, b, c) of integers becomes an instruction for floats: rewritten to ((a) * (b) + (c)), which HLSL
//   allows for every mad (docs "mad": precise or not is the implementation's choice).
// - ldexp(x, e) with a float e becomes Ldexp, which takes an integer exponent: rewritten to ((x) * exp2(e)),
//   HLSL's own definition.
// - The values of a byte address buffer's Interlocked methods are uint: int literals become uint.
//
// - InterlockedCompareStore, which glslang does not have, becomes InterlockedCompareExchange with a variable
//   for the old value, where the call is a statement of its own.
//
// A function of the text with the name of the intrinsic is not changed.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void write_out_intrinsic_calls(TokenText& text);

}  // namespace penumbra::preparation
