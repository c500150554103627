// Which samplers of a SPIR-V module are used for comparisons and which are not. glslang gives both kinds of
// sampler one type, so it accepts a comparison sampler in a read without comparison; devices do not.
#pragma once

#include <string>
#include <vector>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

struct SamplerUse {
  std::string sampler;  // as the shader declares it
  bool compares = false;
  std::string opcode;  // for example "OpImageGather"
  SourcePlace place;   // line 0 in a module without debug lines
};

// For a module that is legalised and optimised, in its order.
std::vector<SamplerUse> sampler_uses(const SpirvModule& module);

}  // namespace penumbra::shaders
