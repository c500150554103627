// Generates a module from glslang's syntax tree, with corrections of its back end. Internal to this folder.
#pragma once

#include <glslang/Include/intermediate.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// The back end's messages go to `logger`.
SpirvModule generated_words(const glslang::TIntermediate& tree, bool debug_lines,
                            spv::SpvBuildLogger& logger);

// Generates the same with debug lines, for the locations of diagnostics; empty if it cannot be optimised.
SpirvModule words_with_lines(const glslang::TIntermediate& tree, bool optimised, VulkanVersion vulkan);

}  // namespace penumbra::shaders
