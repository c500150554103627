// Invalid uses of memory: groupshared variables outside of compute programs, and local variables or read-only
// buffers that an Interlocked function changes. SPIRV-Tools accepts the last, and rejects the others with
// messages in SPIR-V's terms. Internal to this folder.
#pragma once

#include <vector>

#include "hlsl/stage.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

std::vector<hlsl::Diagnostic> refused_memory(const SpirvModule& module, hlsl::Stage stage);

}  // namespace penumbra::shaders
