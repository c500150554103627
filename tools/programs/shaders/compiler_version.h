// The versions of the compilers that produce SPIR-V: different versions may produce different code.
#pragma once

#include <string>

namespace penumbra::shaders {

std::string compiler_version();  // "glslang 12.0.0, SPIRV-Tools v2023.1"

}  // namespace penumbra::shaders
