#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Texture and sampler reads whose resource is undefined. glslang silently emits such modules, and SPIRV-Tools
// accepts some of them: the shader would sample nothing.
//
// Two kinds: an undefined resource (OpUndef, SPIR-V specification 3.49.1), which results from a texture that
// was never assigned, or that glslang's front end lost because one function reads the same parameter both
// with a comparison sampler and otherwise; and one that is selected at run time (OpPhi, OpSelect), which HLSL
// does not allow.
//
// Reports each once; empty if every texture and sampler that is read is known. It is for modules after
// legalisation: before that, resources may still be passed by value. Accepts malformed words.
std::vector<hlsl::Diagnostic> lost_resources(const SpirvModule& module);

}  // namespace penumbra::shaders
