// Operations that need derivatives (Sample, SampleBias, SampleCmp, CalculateLevelOfDetail, ddx, ddy, fwidth)
// in stages that have none. Internal to this room.
//
// Direct3D takes them in fragment programs alone (X4532 "cannot map expression to vs_5_0 instruction set"; in
// compute from shader model 6.6). glslang reads the largest mip level instead without a word. Compilers
// complain of what is left after optimisation, so the tree says where such operations are written, and the
// optimised module which of them remain.
#pragma once

#include <glslang/Include/intermediate.h>

#include <string>
#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// In the whole tree, with the place of each.
std::vector<ModuleProblem> derivative_reads(const glslang::TIntermediate& tree, const std::string& stage);

// Those of `written` of which the module, which keeps its debug lines, has an instruction on the same line.
std::vector<ModuleProblem> remaining(std::vector<ModuleProblem> written, const SpirvModule& module);

}  // namespace penumbra::shaders
