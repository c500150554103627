// The HLSL that calls a technique's filter.
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// The text that defines float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile).
struct TechniqueCall {
  std::string includes;      // #include lines, resolved in the package's folder
  std::string declarations;  // resources, and the uniforms of its parameters (parameter_packing.h)
  std::string function;
};

// Throws std::invalid_argument for a technique without a filter.
TechniqueCall emit_technique_call(const TechniqueList& list, const Technique& technique);

// What the call names a texture of the graph: _PenumbraMomentsTexture of "moments".
std::string argument_name(const std::string& texture);

}  // namespace penumbra::techniques
