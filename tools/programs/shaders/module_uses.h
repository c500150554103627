#pragma once

#include <optional>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// The instructions with which a fragment shader discards its pixel.
//
// Returns the place of `discard` or `clip` in an optimised module, with line 0 if it has no debug lines. The
// result is empty if there is none.
std::optional<SourcePlace> first_discard(const SpirvModule& module);

// The kind of value that a function returns, in a module that has its functions and names.
//
// Returns whether a function of that name, with any parameters, returns more than one number.
bool returns_several_numbers(const SpirvModule& module, const std::string& function);

// The textures of a module that are not plain 2D textures.
//
// Returns the sampled textures of an optimised module that are cubes, arrays, multisampled, buffers or of
// another number of dimensions.
std::vector<std::string> textures_that_are_not_2d(const SpirvModule& module);

// The samplers of a SPIR-V module that are used for comparisons, and those that are not. glslang gives both
// kinds of sampler one type, so it accepts a comparison sampler in a read without comparison; devices do not.
struct SamplerUse {
  std::string sampler;  // the name that the shader declares
  bool compares = false;
  std::string opcode;  // the instruction, for example "OpImageGather"
  SourcePlace place;   // line 0 in a module without debug lines
};

// Returns the uses in a module that is legalised and optimised, in its order.
std::vector<SamplerUse> sampler_uses(const SpirvModule& module);

}  // namespace penumbra::shaders
