// Reads that do not compare, through a comparison sampler. HLSL has no such overload; glslang accepts them
// and takes what follows for the reference to compare with, or crashes when it finds nothing. Internal to
// this room.
#pragma once

#include <glslang/Include/intermediate.h>

#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// In the whole tree, which generating SPIR-V walks.
std::vector<ModuleProblem> reads_without_comparing(const glslang::TIntermediate& tree);

}  // namespace penumbra::shaders
