// The selections as the include file in which a shader's keywords choose among them
// (ShaderLibrary/Pipelines/TechniqueByKeyword.hlsl).
#pragma once

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Defines float FilterByKeyword(shadow map, its comparison and point samplers, ShadowReceiver, ShadowTile),
// the uniforms of all filters' parameters, and for each of these structs a function that unpacks them. Throws
// InputError where no selection is without a keyword.
std::string emit_keywords_hlsl(const TechniqueList& list);

}  // namespace penumbra::techniques
