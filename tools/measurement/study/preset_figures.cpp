#include "study/preset_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "input/input_error.h"
#include "input/text_line.h"
#include "study/summary.h"

namespace penumbra::study {

namespace {

constexpr const char* figures_begin =
    R"(namespace Penumbra.Editor
{{
    // Means over {0} scenes; Documentation~/presets.md says how they were measured.
    // Written by `penumbra measure --presets` from Documentation~/results/presets/results.tsv; do not edit.
    internal static class PresetFigures
    {{
        /// <summary>One row per preset, in QualityPreset's order; by ascending angular diameter.</summary>
        internal static readonly PresetFigure[][] Rows =
        {{
)";

constexpr const char* figures_end = R"(        };
    }
}
)";

std::string figure(const SummaryLine& line) {
  if (!line.complete || !line.rmse_penumbra || !line.fetches)
    throw InputError("", line.choice.technique + " was not measured on every scene",
                     "measure all presets on the same scenes");
  return fmt::format("                new PresetFigure({:g}f, {:.3f}f, {:.1f}f),\n", line.light_degrees,
                     line.rmse_penumbra->value, line.fetches->value);
}

}  // namespace

void check_presets(const std::vector<std::string>& measured, const std::string& prefix) {
  const auto is_preset = [&prefix](const std::string& technique) { return technique.starts_with(prefix); };
  if (std::none_of(measured.begin(), measured.end(), is_preset))
    throw InputError("", "no quality preset was measured", "measure those whose names begin with " + prefix);
}

std::string preset_figures_csharp(const Results& results, const std::string& prefix) {
  check_presets(technique_names(results), prefix);
  std::string text = fmt::format(figures_begin, scene_names(results).size());
  std::string open;  // the preset whose row is being written
  for (const SummaryLine& line : summarise(results)) {
    if (!line.choice.technique.starts_with(prefix)) continue;
    if (line.choice.technique != open) {
      if (!open.empty()) text += "            },\n";
      open = line.choice.technique;
      text += fmt::format("            new[]  // {}\n            {{\n", in_one_line(line.choice.title));
    }
    text += figure(line);
  }
  return text + "            },\n" + figures_end;
}

}  // namespace penumbra::study
