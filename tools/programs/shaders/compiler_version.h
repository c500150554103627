// Which compilers make our SPIR-V: two versions may make different code of one shader.
#pragma once

#include <string>

namespace penumbra::shaders {

std::string compiler_version();  // "glslang 12.0.0, SPIRV-Tools v2023.1"

}  // namespace penumbra::shaders
