// Operations that need derivatives (Sample, SampleBias, SampleCmp, CalculateLevelOfDetail, ddx, ddy, fwidth)
// in stages that have none. Internal to this folder.
//
// Direct3D accepts them only in fragment programs (X4532 "cannot map expression to vs_5_0 instruction set";
// in compute from shader model 6.6). glslang silently reads the largest mip level instead. Compilers report
// only what remains after optimisation, so the syntax tree gives the locations of such operations, and the
// optimised module those that remain.
#pragma once

#include <glslang/Include/intermediate.h>

#include <string>
#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Finds them in the whole syntax tree, each with its location.
std::vector<hlsl::Diagnostic> derivative_reads(const glslang::TIntermediate& tree, const std::string& stage);

// Returns those of `written` for which the module, which keeps its debug lines, has an instruction on the
// same line.
std::vector<hlsl::Diagnostic> remaining(std::vector<hlsl::Diagnostic> written, const SpirvModule& module);

}  // namespace penumbra::shaders
