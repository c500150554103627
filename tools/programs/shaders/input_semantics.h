// The HLSL semantics of a stage's inputs, which SPIR-V does not keep: it numbers them. Internal to this room.
#pragma once

#include <glslang/Include/intermediate.h>
#include <glslang/MachineIndependent/localintermediate.h>

#include <cstdint>
#include <map>
#include <string>

namespace penumbra::shaders {

// By location, in upper case and with their number: "TEXCOORD0". System values have no location.
std::map<std::uint32_t, std::string> input_semantics(const glslang::TIntermediate& tree);

}  // namespace penumbra::shaders
