// Instructions that the stage does not have: discard outside of fragment programs, barriers outside of
// compute programs. SPIRV-Tools rejects both, with messages in SPIR-V's terms. Internal to this folder.
#pragma once

#include <vector>

#include "hlsl/stage.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

std::vector<hlsl::Diagnostic> refused_instructions(const SpirvModule& module, hlsl::Stage stage);

}  // namespace penumbra::shaders
