// Through which samplers a SPIR-V module compares and through which it does not. glslang gives both kinds of
// sampler one type, so it accepts a comparison sampler where a texture is only read; a device does not.
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

// Of a module that is legalised and optimised, in its order.
std::vector<SamplerUse> sampler_uses(const SpirvModule& module);

}  // namespace penumbra::shaders
