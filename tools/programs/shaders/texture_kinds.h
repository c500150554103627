// The textures of a module that are not plain 2D textures.
#pragma once

#include <string>
#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Returns the sampled textures of an optimised module that are cubes, arrays, multisampled, buffers or of
// another number of dimensions.
std::vector<std::string> textures_that_are_not_2d(const SpirvModule& module);

}  // namespace penumbra::shaders
