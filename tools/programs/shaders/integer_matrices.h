// Matrices of integers in memory, such as a cbuffer's int4x4: SPIR-V, GLSL and Metal have matrices of floats
// alone (SPIR-V specification, OpTypeMatrix). Internal to this room.
#pragma once

#include <string>
#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// `optimised`: those that are left in this module; `text` and `file`: its source, for their places.
std::vector<ModuleProblem> integer_matrices(const SpirvModule& optimised, const std::string& text,
                                            const std::string& file);

}  // namespace penumbra::shaders
