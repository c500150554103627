// The words for what only one of two reports has, when a run is compared with a baseline.
#pragma once

#include <string>
#include <vector>

namespace penumbra {

// Returns a line for each that the baseline lacks, and for each that it alone has.
std::string baseline_lines(const std::vector<std::string>& unknown, const std::vector<std::string>& gone);

// Returns "2 rows not in the baseline, 1 only there".
std::string baseline_counts(const std::string& thing, std::size_t unknown, std::size_t gone);

}  // namespace penumbra
