// The README's result block: hardware, driver and command, then the table, then one chart.
#pragma once

#include <string>
#include <string_view>

#include "study/results.h"

namespace penumbra::study {

inline constexpr std::string_view kResultBlock = "results";  // as input/markdown.h names blocks

// Markdown: penumbra RMSE and fetches of every technique by light, mean over scenes, then every scene for
// itself. chart_path is written as given. No time stands in it: a software device's ranks nothing.
std::string result_block(const Results& results, const std::string& chart_path);

// The text with what stands between the two markers replaced by the block; the rest is kept byte by byte.
// Throws InputError naming `name` when a marker is missing, stands twice, or the end comes before the
// beginning.
std::string replace_result_block(const std::string& text, const std::string& block, const std::string& name);

}  // namespace penumbra::study
