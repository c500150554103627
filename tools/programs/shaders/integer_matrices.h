// Integer matrices in memory, such as a cbuffer's int4x4: SPIR-V, GLSL and Metal have only float matrices
// (SPIR-V specification, OpTypeMatrix). Internal to this folder.
#pragma once

#include <string>
#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Finds those that remain in `optimised`; `text` and `file` are its source, for the locations.
std::vector<hlsl::Diagnostic> integer_matrices(const SpirvModule& optimised, const std::string& text,
                                               const std::string& file);

}  // namespace penumbra::shaders
