// The selections that the renderer feature offers, as its C# enumeration
// (Runtime/Settings/ShadowTechnique.cs) and as rows of the table that it reads; TechniqueReader.cs says how.
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Both throw InputError where the values of the selections are not 0, 1, 2 ...: the table is indexed by them.
std::string emit_selections_csharp(const TechniqueList& list);
std::string selection_rows(const TechniqueList& list);

}  // namespace penumbra::techniques
