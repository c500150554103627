// Takes functions that no entry point calls out of a SPIR-V module, with their names and decorations.
//
// After inlining that is nearly all of the module. SPIRV-Tools' own pass for it unlinks one instruction after
// the other from its tables; on words it is two readings. What is no module is left alone.
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

void drop_uncalled_functions(SpirvModule& module);

}  // namespace penumbra::shaders
