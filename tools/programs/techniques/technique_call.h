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

  std::string source() const;  // all of it, with the library's macros and structs
};

// Throws std::invalid_argument for a technique without a filter.
TechniqueCall emit_technique_call(const TechniqueList& list, const Technique& technique);

// The uniform of uniform_name() that holds a rule's values: with "From2" where the rule is from cascade 2 on.
std::string uniform_name(const ParameterStruct& parameters, std::size_t vector, const CascadeRule& rule);

// What the call names a texture of the graph: _PenumbraMomentsTexture of "moments".
std::string argument_name(const std::string& texture);

// The line that declares it under this name, by what its texels hold.
std::string declaration_of(const GraphTexture& texture);

}  // namespace penumbra::techniques
