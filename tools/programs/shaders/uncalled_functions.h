// Removes functions that no entry point calls from a SPIR-V module, with their names and decorations.
//
// After inlining that is nearly all of the module. SPIRV-Tools' own pass unlinks every instruction from its
// tables; on words, two scans suffice. Malformed words are not changed.
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

void drop_uncalled_functions(SpirvModule& module);

}  // namespace penumbra::shaders
