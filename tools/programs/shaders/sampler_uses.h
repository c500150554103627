// The samplers of a SPIR-V module that are used for comparisons, and those that are not. glslang gives both
// kinds of sampler one type, so it accepts a comparison sampler in a read without comparison; devices do not.
#pragma once

#include <string>
#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

struct SamplerUse {
  std::string sampler;  // the name that the shader declares
  bool compares = false;
  std::string opcode;  // the instruction, for example "OpImageGather"
  SourcePlace place;   // line 0 in a module without debug lines
};

// Returns the uses in a module that is legalised and optimised, in its order.
std::vector<SamplerUse> sampler_uses(const SpirvModule& module);

}  // namespace penumbra::shaders
