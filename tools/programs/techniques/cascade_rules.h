// Rules for far cascades in the renderer feature: which of them hold where a shader keyword selects the
// filter, and the uniforms that they need.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// A vector of a rule's uniforms: what another one of the frame holds, but for the components that are the
// rule's own.
struct CascadeVector {
  std::string uniform;
  std::string base;  // empty: all components are its own
  std::array<bool, 4> own{};
  std::array<float, 4> value{};  // whole, of the technique as it is listed
};

// In the order of the rules.
std::vector<CascadeVector> cascade_vectors(const TechniqueList& list, const Technique& technique);

// Those of the programs that the technique runs: its own, or where its filter is called by a pass of a shader
// those of the selection whose keyword is on.
const std::vector<CascadeRule>& compiled_rules(const TechniqueList& list, const Technique& technique);

// What the rule's filter is told: its values over those of the technique, if it has the same filter.
std::map<std::string, std::vector<double>> values_of(const CascadeRule& rule, const Technique& technique);

// As a row of the C# table of all selections.
std::string emit_cascade_row(const TechniqueList& list, const Technique& technique);

}  // namespace penumbra::techniques
