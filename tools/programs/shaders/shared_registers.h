// Two resources at one explicit register: FXC X4500, X4578. Internal to this folder.
//
// HLSL's compilers report it if the program uses both.
#pragma once

#include <string>
#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// `optimised` is the module with the names of the resources that it still uses; `text` and `file` are its
// source.
std::vector<hlsl::Diagnostic> shared_registers(const SpirvModule& optimised, const std::string& text,
                                               const std::string& file);

}  // namespace penumbra::shaders
