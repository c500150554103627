// Texture2D.GatherCmp: glslang mistakes an operand for a bias and adds Bias to OpImageDrefGather, which
// SPIR-V allows only with implicit levels (specification, 3.14). A gather reads the first level.
#pragma once

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Removes the operand from OpImageDrefGather, and the capability that it requires from the module.
void drop_gather_bias(SpirvModule& module);

}  // namespace penumbra::shaders
