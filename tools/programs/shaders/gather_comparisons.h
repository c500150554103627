// Texture2D.GatherCmp: glslang takes an operand of its own for a bias and writes Bias into OpImageDrefGather,
// which SPIR-V allows for implicit levels alone (specification, 3.14). A gather reads the first level.
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// OpImageDrefGather loses the operand, the module what it asks for the sake of it.
void drop_gather_bias(SpirvModule& module);

}  // namespace penumbra::shaders
