// The signature of a compiled entry point, from its syntax tree and its module. Internal to this folder.
#pragma once

#include <glslang/MachineIndependent/localintermediate.h>

#include <span>

#include "preparation/semantic_names.h"
#include "shaders/stage_signature.h"

namespace penumbra::shaders {

// Returns inputs and outputs in the order of their declaration, without their places.
Signature tree_signature(const glslang::TIntermediate& tree, std::span<const std::uint32_t> spirv);

// `places` are those of the same entry point.
void add_places(const std::vector<preparation::SemanticPlace>& places, Signature& signature);

}  // namespace penumbra::shaders
