// Direct3D 11's limits of a compute program's group: threads and shared memory (FXC X3655, X4586). Internal
// to this folder.
//
// https://learn.microsoft.com/windows/win32/direct3dhlsl/sm5-attributes-numthreads
#pragma once

#include <glslang/Include/intermediate.h>

#include <string>
#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Finds [numthreads] beyond 1024, 1024 and 64 threads along the axes or 1024 in total, and more than 32 KiB
// of groupshared variables that `optimised` still uses. `text` and `file` are the source, for the locations.
std::vector<hlsl::Diagnostic> beyond_group_limits(const glslang::TIntermediate& tree,
                                                  const SpirvModule& optimised, const std::string& text,
                                                  const std::string& file);

}  // namespace penumbra::shaders
