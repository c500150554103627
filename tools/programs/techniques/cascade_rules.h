// Rules for far cascades in the renderer feature: those that hold where a shader keyword selects the filter,
// and the uniforms that they need.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

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
