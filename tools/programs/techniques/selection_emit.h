// The selections that the renderer feature offers, as its C# enumeration and the table beside it
// (Runtime/Settings/ShadowTechnique.cs).
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Throws InputError where the values of the selections are not 0, 1, 2 ...: the table is indexed by them.
std::string emit_selections_csharp(const TechniqueList& list);

}  // namespace penumbra::techniques
