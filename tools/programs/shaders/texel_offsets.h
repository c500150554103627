// Offsets of texture reads that HLSL's compilers reject and SPIR-V accepts: outside of -8..7 texels, or not
// constant. Internal to this folder.
//
// FXC: "offset texture instructions must take offset which can resolve to integer literal in the range -8 to
// 7" (https://learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-to-sample), applied after
// optimisation. Gather accepts any offset.
#pragma once

#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Reports each once. It is for modules after legalisation. Accepts malformed words.
std::vector<hlsl::Diagnostic> refused_offsets(const SpirvModule& module);

}  // namespace penumbra::shaders
