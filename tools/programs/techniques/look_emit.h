// The package's looks, which the manifests list under "looks", as C# from which the renderer feature and the
// Volume read them (Runtime/Settings/ShadowLook.cs).
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Writes an enumeration of them in the list's order with Custom behind, and the table of their values in that
// order.
std::string emit_looks_csharp(const TechniqueList& list);

}  // namespace penumbra::techniques
