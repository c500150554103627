// The options of the renderer feature, as the C# constants that ShadowOptions, the Volume and the inspectors
// use (Runtime/Settings/OptionTable.cs).
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// Writes for each option a class with its Label, its Tooltip and, for numbers, Min and Max.
std::string emit_options_csharp(const TechniqueList& list);

}  // namespace penumbra::techniques
