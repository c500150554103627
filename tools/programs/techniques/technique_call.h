// The HLSL that calls a technique's filter.
#pragma once

#include <array>

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

// Returns the uniform of uniform_name() that holds a rule's values: with "From2" where the rule is from
// cascade 2 on.
std::string uniform_name(const ParameterStruct& parameters, std::size_t vector, const CascadeRule& rule);

// Returns the name of a texture of the graph in the call: _PenumbraMomentsTexture for "moments".
std::string argument_name(const std::string& texture);

// Returns the line that declares it under this name, by the type of its texels.
std::string declaration_of(const GraphTexture& texture);

// Rules for far cascades in the renderer feature: those that hold where a shader keyword selects the filter,
// and the uniforms that they need.
//
// A vector of a rule's uniforms: the content of another vector of the frame, except for the components that
// are the rule's own.
struct CascadeVector {
  std::string uniform;
  std::string base;  // if empty, all components are its own
  std::array<bool, 4> own{};
  std::array<float, 4> value{};  // the whole vector, for the technique as it is listed
};

// Returns the vectors in the order of the rules.
std::vector<CascadeVector> cascade_vectors(const TechniqueList& list, const Technique& technique);

// Returns the rules in the programs that the technique runs: its own. If a pass of a shader calls its filter,
// they are those of the selection whose keyword is on.
const std::vector<CascadeRule>& compiled_rules(const TechniqueList& list, const Technique& technique);

// Returns the values for the rule's filter: the rule's values replace those of the technique, if it has the
// same filter.
std::map<std::string, std::vector<double>> values_of(const CascadeRule& rule, const Technique& technique);

}  // namespace penumbra::techniques
