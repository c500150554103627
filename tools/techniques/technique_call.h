// The HLSL that calls a technique's filter, and the structs that it is told.
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// The checked-in copy of the parameter structs, ShaderLibrary/Core/TechniqueParameters.hlsl.
std::string emit_parameter_structs_hlsl(const TechniqueList& list);

// The text that defines float ResolveTechnique(ShadowReceiver receiver, ShadowTile tile).
struct TechniqueCall {
  std::string includes;      // #include lines, resolved in the package's folder
  std::string declarations;  // resources, and uniforms, one per field: <prefix><Struct>_<field>
  std::string function;
};

// Throws std::invalid_argument for a technique without a filter.
TechniqueCall emit_technique_call(const TechniqueList& list, const Technique& technique,
                                  const std::string& uniform_prefix);

}  // namespace penumbra::techniques
