// The cost and error of the quality presets, as C# for the package's inspector
// (Editor/Inspectors/PresetFigures.cs).
#pragma once

#include <string>

#include "study/results.h"

namespace penumbra::study {

// Of every technique whose name begins with `prefix`, in the results' order, and each light: penumbra RMSE
// and fetches per pixel, means over the scenes. Throws InputError without one, or where a figure is missing.
std::string preset_figures_csharp(const Results& results, const std::string& prefix);

}  // namespace penumbra::study
