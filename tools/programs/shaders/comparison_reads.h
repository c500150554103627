// Reads without comparison through a comparison sampler. HLSL has no such overload; glslang accepts them and
// treats the next argument as the comparison reference, or crashes if there is none. Internal to this folder.
#pragma once

#include <glslang/Include/intermediate.h>

#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Finds them in the whole syntax tree, because SPIR-V is generated for all of it.
std::vector<hlsl::Diagnostic> reads_without_comparing(const glslang::TIntermediate& tree);

}  // namespace penumbra::shaders
