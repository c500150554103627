// Integers divided by a constant zero. Internal to this room.
//
// FXC refuses them (X4010 "Unsigned integer divide by zero"), and so does DXC's validation (DXIL.rst,
// InstrNoIDivByZero); SPIRV-Tools takes the result for 0. Compilers complain of divisions that are made:
// before the module is optimised each such division is marked, and what remains of the marks is reported.
#pragma once

#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// These three read words of any kind without harm.
bool divides_by_zero(const SpirvModule& unoptimised);
// Every such division becomes one of a value by itself, which the optimiser leaves alone.
void mark_zero_divisions(SpirvModule& unoptimised);
// Each once. Of a module that was marked and then optimised, with its debug lines.
std::vector<ModuleProblem> marked_divisions(const SpirvModule& optimised);

}  // namespace penumbra::shaders
