// The result blocks of README and pages: tables of means over the scenes, and the run's settings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/results.h"
#include "study/technique_facts.h"

namespace penumbra::study {

// The block's name in the sense of input/markdown.h.
inline constexpr std::string_view kResultBlock = "results";

enum class BlockForm {
  full,   // a table of errors, the chart, and a table of costs, with a row for each technique
  brief,  // one table, with a row for each technique
  line,   // one sentence: penumbra RMSE and fetches under the middle light
};

struct BlockStyle {
  std::string chart_path;  // written as given
  std::vector<std::string>
      rows{};  // techniques, in this order; those that were not measured are left out; empty means all
  BlockForm form = BlockForm::full;
  FactsOfTechniques facts{};  // facts for the full form, one row for each technique
};

// Throws InputError when rows are chosen and none of them is among the techniques that were measured, or will
// be.
void check_rows(const std::vector<std::string>& rows, const std::vector<std::string>& measured);

// The block is Markdown: means over scenes of errors, rates and fetches with their intervals. Techniques go
// by their titles; the full form gives their names, too. It contains no times, because those of a software
// device do not rank techniques. Throws InputError when none of the rows was measured.
std::string result_block(const Results& results, const BlockStyle& style);

// Returns the text in which the block replaces what stands between the two markers of its name; the rest is
// kept byte by byte. Throws InputError naming `name` when a marker is missing, stands twice, or the end comes
// before the beginning.
std::string replace_result_block(const std::string& text, const std::string& block, const std::string& name,
                                 std::string_view block_name = kResultBlock);

// Throws InputError when none of the techniques that were measured, or will be, has a name that begins with
// `prefix`.
void check_presets(const std::vector<std::string>& measured, const std::string& prefix);

// Has the figures of every technique whose name begins with `prefix`, in the results' order, and each light:
// penumbra RMSE and fetches per pixel, means over the scenes. Throws InputError without one, or where a
// figure is missing.
std::string preset_figures_csharp(const Results& results, const std::string& prefix);

}  // namespace penumbra::study
