// Textures that a module reads with more coordinates than they have: a Texture2D that is handed to a function
// as its Texture2DArray, as a plain texture of the screen is where both eyes are drawn at once. HLSL does not
// allow it; glslang lets it pass, and SPIR-V is content with a coordinate of more components than it needs
// (specification, OpImageFetch and its kin), so that every layer would be the first.
#pragma once

#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Each once, by the texture's name where the module has names. For modules after legalisation. Reads words of
// any kind without harm.
std::vector<ModuleProblem> misread_textures(const SpirvModule& module);

}  // namespace penumbra::shaders
