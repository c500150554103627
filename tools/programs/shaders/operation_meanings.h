// Calls of intrinsic functions that glslang's SPIR-V back end turns into other instructions than HLSL means.
// They are put right in the tree, where the types of the arguments are known. Internal to this room.
//
// - abs(u) of an unsigned integer is u; the back end takes it for signed.
// - mad(a, b, c) is a * b + c, of whole numbers as well, for which there is no Fma. HLSL leaves open whether
// it rounds
//   once or twice.
// - -u of an unsigned integer is 0 - u: SPIRV-Tools 2023.1 takes -(u / 2) for u / -2.
// - ldexp(x, e) has a float e and is x * exp2(e); Ldexp takes whole exponents.
#pragma once

#include <glslang/Include/intermediate.h>

namespace penumbra::shaders {

void put_operations_right(glslang::TIntermediate& tree);

}  // namespace penumbra::shaders
