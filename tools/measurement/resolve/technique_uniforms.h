// The uniforms of a technique's parameters, packed as the shaders unpack them
// (techniques/parameter_packing.h).
#pragma once

#include "resolve/uniform_values.h"
#include "techniques/technique_list.h"

namespace penumbra::resolve {

enum class Taps { as_listed, unlimited };  // unlimited: the technique's own T3 overrides

UniformValues parameter_uniforms(const techniques::TechniqueList& list,
                                 const techniques::Technique& technique, Taps taps = Taps::as_listed);

}  // namespace penumbra::resolve
