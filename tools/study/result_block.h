// The result blocks of README and pages: what was run where, then a table per light.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/results.h"

namespace penumbra::study {

inline constexpr std::string_view kResultBlock = "results";  // as input/markdown.h names blocks

struct BlockStyle {
  std::string chart_path;  // written as given
  std::vector<std::string>
      rows;            // techniques, in this order; those that were not measured are left out; empty: all
  bool brief = false;  // the middle light's table in sight, all else folded; no chart, no tables by scene
};

// Markdown: means over scenes of errors, rates and fetches with their intervals, a table per light; then the
// chart and the penumbra RMSE of every scene. No time stands in it: a software device's ranks nothing. Throws
// InputError when none of the rows was measured.
std::string result_block(const Results& results, const BlockStyle& style);

// The text with what stands between the two markers of the block's name replaced by the block; the rest is
// kept byte by byte. Throws InputError naming `name` when a marker is missing, stands twice, or the end comes
// before the beginning.
std::string replace_result_block(const std::string& text, const std::string& block, const std::string& name,
                                 std::string_view block_name = kResultBlock);

}  // namespace penumbra::study
