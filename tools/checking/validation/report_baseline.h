// Compares the findings of a run with those of an earlier one, whose JSON report is the baseline.
//
// A finding is the same where rule, file, message and the text of its line are: moved lines change nothing.
// Only errors and warnings are compared (Finding says which messages of packages are notes).
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "validation/report.h"

namespace penumbra::validation {

struct FindingComparison {
  std::vector<std::string> unknown;  // findings that the baseline lacks, as compilers print them
  std::vector<std::string> gone;     // findings of the baseline that this run could have had
  std::size_t compared = 0;
};

// Returns ReportStyle::known. File names are relative to the style's root in both reports.
std::set<std::string> known_findings(const ValidationReport& baseline, const ReportStyle& style);

// A finding of the baseline counts as `gone` only where this run has its file and target; a shard, which has
// not all variants, has none.
FindingComparison compare_with_baseline(const ValidationReport& report, const ValidationReport& baseline,
                                        const ReportStyle& style);

std::string comparison_text(const FindingComparison& comparison);

}  // namespace penumbra::validation
