// Tells what a target's text means: the text that SPIRV-Cross emits is compiled to SPIR-V a second time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shaders/cross_compile.h"

namespace penumbra::preparation {

// Compiles a compute shader by way of GLSL, ESSL or HLSL. Throws with the messages when either way fails.
// Resources keep their names, but for a "_1" that GLSL puts behind some; the entry point is "main".
std::vector<std::uint32_t> through_target(const std::vector<std::uint32_t>& spirv, shaders::Target target);

}  // namespace penumbra::preparation
