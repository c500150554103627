// The cost and error of the quality presets, as C# for the package's inspector
// (Editor/Inspectors/PresetFigures.cs).
#pragma once

#include <string>
#include <vector>

#include "study/results.h"

namespace penumbra::study {

// Throws InputError when none of the techniques that were measured, or will be, has a name that begins with
// `prefix`.
void check_presets(const std::vector<std::string>& measured, const std::string& prefix);

// Has the figures of every technique whose name begins with `prefix`, in the results' order, and each light:
// penumbra RMSE and fetches per pixel, means over the scenes. Throws InputError without one, or where a
// figure is missing.
std::string preset_figures_csharp(const Results& results, const std::string& prefix);

}  // namespace penumbra::study
