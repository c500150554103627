// The package's quality presets: the techniques called preset-..., as C# from which the renderer feature
// reads them (Runtime/Settings/PresetTable.cs).
#pragma once

#include <string>

#include "techniques/technique_list.h"

namespace penumbra::techniques {

inline constexpr const char* preset_prefix = "preset-";
// This pass halves the resolution of a graph.
inline constexpr const char* upsampling_pass = "Upsample";

// The row order is the list's; QualityPreset names the rows in that order. Throws InputError for a preset
// that ShadowOptions cannot express: a chain or a technique that the feature does not have.
std::string emit_presets_csharp(const TechniqueList& list);

}  // namespace penumbra::techniques
