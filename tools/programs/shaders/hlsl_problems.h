// Constructs in a module that HLSL does not allow, and that the front end accepts. Internal to this folder.
#pragma once

#include <glslang/Include/intermediate.h>

#include "shaders/compile.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Finds reads of lost resources (module_problems.h), and reads with derivatives in stages that have none.
// `optimised` is the module of that tree. The module is generated again, with debug lines, only if a problem
// is possible.
std::vector<hlsl::Diagnostic> hlsl_problems(const CompileRequest& request, const glslang::TIntermediate& tree,
                                            const SpirvModule& optimised);

}  // namespace penumbra::shaders
