#pragma once

#include "techniques/technique_list.h"

namespace penumbra::techniques {

// The options of the renderer feature, as the C# constants that ShadowOptions, the Volume and the inspectors
// use (Runtime/Settings/OptionTable.cs).
//
// Writes for each option a class with its Label, its Tooltip and, for numbers, Min and Max.
std::string emit_options_csharp(const TechniqueList& list);

// The package's looks, which the manifests list under "looks", as C# from which the renderer feature and the
// Volume read them (Runtime/Settings/ShadowLook.cs).
//
// Writes an enumeration of them in the list's order with Custom behind, and the table of their values in that
// order.
std::string emit_looks_csharp(const TechniqueList& list);

// The package's quality presets: the techniques called preset-..., as C# from which the renderer feature
// reads them (Runtime/Settings/PresetTable.cs).
inline constexpr const char* preset_prefix = "preset-";
// This pass halves the resolution of a graph.
inline constexpr const char* upsampling_pass = "Upsample";

// The row order is the list's; QualityPreset names the rows in that order. Throws InputError for a preset
// that ShadowOptions cannot express: a chain or a technique that the feature does not have.
std::string emit_presets_csharp(const TechniqueList& list);

}  // namespace penumbra::techniques
