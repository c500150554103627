// Matrices of whole numbers and bools, which HLSL has and SPIR-V has not (SPIR-V specification, OpTypeMatrix:
// the components are floats).
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// OpTypeMatrix of ints and bools becomes an array of as many vectors, which every instruction that glslang
// makes on them takes as well: loads and stores, construction, extraction, access chains. Nothing changes
// where one is a member of a buffer, whose elements an array of rows would not find; validation then refuses
// the module.
void make_whole_matrices_arrays(SpirvModule& module);

}  // namespace penumbra::shaders
