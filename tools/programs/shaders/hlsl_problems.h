// All checks for constructs in a module that HLSL does not allow. Internal to this folder.
#pragma once

#include <glslang/Include/intermediate.h>

#include "shaders/compile.h"
#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// `optimised` is the module of that tree; `divides` means that it divides by zero before it is optimised
// (divides_by_zero()). The module is generated again, with debug lines, only if a problem is possible.
std::vector<hlsl::Diagnostic> hlsl_problems(const CompileRequest& request, const glslang::TIntermediate& tree,
                                            const SpirvModule& optimised, bool divides);

// Integers divided by a constant zero.
//
// FXC rejects them (X4010 "Unsigned integer divide by zero"), and so does DXC's validation (DXIL.rst,
// InstrNoIDivByZero); SPIRV-Tools folds the result to 0. Compilers report only reachable divisions: before
// the module is optimised each such division is marked, and the remaining marks are reported.
//
// These three functions accept malformed words.
bool divides_by_zero(const SpirvModule& unoptimised);
// Replaces every such division by a division of a value by itself, which the optimiser does not fold.
void mark_zero_divisions(SpirvModule& unoptimised);
// Reports each once. It is for a module that was marked and then optimised, with debug lines.
std::vector<hlsl::Diagnostic> marked_divisions(const SpirvModule& optimised);

}  // namespace penumbra::shaders
