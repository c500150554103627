// GatherCmp for HLSL: Direct3D 11 has it (shader model 5), SPIRV-Cross rejects it ("GatherCmp does not exist
// in HLSL"). It is emitted as SampleCmpLevelZero, which takes the same arguments, with an offset that no
// shader can have; then its name and offset are corrected in the text. Internal to this folder.
#pragma once

#include <optional>
#include <string>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Returns the module for SPIRV-Cross; nothing if it has no such gather, or one whose offset is not constant.
std::optional<SpirvModule> with_marked_gathers(const SpirvModule& module);

// Restores the gathers in the text emitted for that module.
std::string with_named_gathers(std::string hlsl);

}  // namespace penumbra::shaders
