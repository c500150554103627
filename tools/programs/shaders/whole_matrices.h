// Matrices of integers and bools, which HLSL has and SPIR-V does not (SPIR-V specification, OpTypeMatrix: the
// components are floats).
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// OpTypeMatrix of ints and bools becomes an array of vectors, which every instruction that glslang emits for
// them also accepts: loads and stores, construction, extraction, access chains. A matrix that is a member of
// a buffer is not changed, because its layout differs from that of an array; validation then rejects the
// module.
void make_whole_matrices_arrays(SpirvModule& module);

}  // namespace penumbra::shaders
