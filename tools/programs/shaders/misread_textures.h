// Textures that a module reads with more coordinates than they have: a Texture2D that is passed to a function
// as its Texture2DArray, as happens to a screen texture if both eyes are drawn at once. HLSL does not allow
// it; glslang accepts it, and SPIR-V permits coordinates with excess components (specification, OpImageFetch
// and similar), so every layer would be the first.
#pragma once

#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Reports each once, with the texture's name if the module has names. It is for modules after legalisation.
// Accepts malformed words.
std::vector<hlsl::Diagnostic> misread_textures(const SpirvModule& module);

}  // namespace penumbra::shaders
