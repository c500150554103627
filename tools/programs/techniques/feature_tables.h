#pragma once

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// The graphs of the manifests as rows of the table that the renderer feature reads; TechniqueReader.cs says
// how. Graphs with a stencil are left out, because the feature does not draw them.
//
// Throws InputError where two graphs of the list have one name.
std::string graph_rows(const TechniqueList& list);

// The selections that the renderer feature offers, as its C# enumeration
// (Runtime/Settings/ShadowTechnique.cs) and as rows of the table that it reads; TechniqueReader.cs says how.
//
// Both throw InputError where the values of the selections are not 0, 1, 2 ...: the table is indexed by them.
std::string emit_selections_csharp(const TechniqueList& list);
std::string selection_rows(const TechniqueList& list);

}  // namespace penumbra::techniques
