// Constant arrays that code indexes. glslang copies the whole array into a local variable before each access
// (before SPIR-V 1.4, which its HLSL front end does not produce), and lavapipe executes the copies: a filter
// that reads a table of 100 points in a loop spends nearly all of its time on them.
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Local variables that hold one constant wherever they are stored, and are otherwise only read, get it as
// their initialiser in place of the stores: drivers then keep the table in constant memory. Meaning is
// unchanged.
void initialise_tables(SpirvModule& module);

}  // namespace penumbra::shaders
