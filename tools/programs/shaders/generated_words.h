// From glslang's tree to a module, with what its back end leaves to be put right. Internal to this room.
#pragma once

#include <glslang/Include/intermediate.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// What the back end has to say goes to `logger`.
SpirvModule generated_words(const glslang::TIntermediate& tree, bool debug_lines,
                            spv::SpvBuildLogger& logger);

// The same once more with its lines, for the places of messages; empty when it cannot be optimised.
SpirvModule words_with_lines(const glslang::TIntermediate& tree, bool optimised, VulkanVersion vulkan);

}  // namespace penumbra::shaders
