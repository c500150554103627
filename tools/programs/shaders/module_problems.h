#pragma once

#include "hlsl/stage.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Instructions that the stage does not have: discard outside of fragment programs, barriers outside of
// compute programs. SPIRV-Tools rejects both, with messages in SPIR-V's terms.
std::vector<hlsl::Diagnostic> refused_instructions(const SpirvModule& module, hlsl::Stage stage);

// Invalid uses of memory: groupshared variables outside of compute programs, and local variables or read-only
// buffers that an Interlocked function changes. SPIRV-Tools accepts the last, and rejects the others with
// messages in SPIR-V's terms.
std::vector<hlsl::Diagnostic> refused_memory(const SpirvModule& module, hlsl::Stage stage);

// Offsets of texture reads that HLSL's compilers reject and SPIR-V accepts: outside of -8..7 texels, or not
// constant.
//
// FXC: "offset texture instructions must take offset which can resolve to integer literal in the range -8 to
// 7" (https://learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-to-sample), applied after
// optimisation. Gather accepts any offset.
//
// Reports each once. It is for modules after legalisation. Accepts malformed words.
std::vector<hlsl::Diagnostic> refused_offsets(const SpirvModule& module);

// Textures that a module reads with more coordinates than they have: a Texture2D that is passed to a function
// as its Texture2DArray, as happens to a screen texture if both eyes are drawn at once. HLSL does not allow
// it; glslang accepts it, and SPIR-V permits coordinates with excess components (specification, OpImageFetch
// and similar), so every layer would be the first.
//
// Reports each once, with the texture's name if the module has names. It is for modules after legalisation.
// Accepts malformed words.
std::vector<hlsl::Diagnostic> misread_textures(const SpirvModule& module);

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
