// All checks for constructs in a module that HLSL does not allow. Internal to this folder.
#pragma once

#include <glslang/Include/intermediate.h>

#include <vector>

#include "shaders/compile.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// `optimised` is the module of that tree; `divides` means that it divides by zero before it is optimised
// (zero_divisions.h). The module is generated again, with debug lines, only if a problem is possible.
std::vector<hlsl::Diagnostic> hlsl_problems(const CompileRequest& request, const glslang::TIntermediate& tree,
                                            const SpirvModule& optimised, bool divides);

}  // namespace penumbra::shaders
