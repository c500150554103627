// Textures and samplers that a module reads without saying which ones. glslang makes such modules without a
// word, and SPIRV-Tools finds some of them valid: the shader would sample nothing.
//
// Two kinds: an undefined one (OpUndef, SPIR-V specification 3.49.1), which is what is left of a texture that
// was never assigned, or that glslang's front end lost because one function reads the same parameter both by
// a comparison sampler and otherwise; and one chosen at run time (OpPhi, OpSelect), which HLSL does not
// allow.
#pragma once

#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Each once; empty when every texture and sampler that is read is known. For modules after legalisation:
// before it resources are still passed by value. Reads words of any kind without harm.
std::vector<ModuleProblem> lost_resources(const SpirvModule& module);

}  // namespace penumbra::shaders
