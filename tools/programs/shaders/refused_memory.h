// Memory that a program cannot use as it does: groupshared variables outside of compute programs, and local
// variables that an Interlocked function changes. SPIRV-Tools refuses both in words of its own. Internal to
// this room.
#pragma once

#include <vector>

#include "hlsl/stage.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

std::vector<ModuleProblem> refused_memory(const SpirvModule& module, hlsl::Stage stage);

}  // namespace penumbra::shaders
