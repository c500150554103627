// The HLSL that calls a technique's filter.
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// The text that defines float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile, int cascade).
struct TechniqueCall {
  std::string includes;      // #include lines, resolved in the package's folder
  std::string declarations;  // resources, and the uniforms of its parameters (parameter_packing.h)
  std::string function;
};

// Throws std::invalid_argument for a technique without a filter.
TechniqueCall emit_technique_call(const TechniqueList& list, const Technique& technique);

// Returns the uniform of uniform_name() that holds a rule's values: with "From2" where the rule is from
// cascade 2 on.
std::string uniform_name(const ParameterStruct& parameters, std::size_t vector, const CascadeRule& rule);

// Returns the name of a texture of the graph in the call: _PenumbraMomentsTexture for "moments".
std::string argument_name(const std::string& texture);

// Returns the line that declares it under this name, by the type of its texels.
std::string declaration_of(const GraphTexture& texture);

}  // namespace penumbra::techniques
