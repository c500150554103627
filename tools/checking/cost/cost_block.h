// A report's figures as Markdown, for the documentation.
#pragma once

#include <string>

#include "cost/cost_report.h"

namespace penumbra::cost {

// Returns driver and command, then a table for each family with every row.
std::string cost_block(const CostReport& report);

// Returns a few techniques as Unity runs them on these GPUs (reversed Z), all families side by side.
std::string cost_summary_block(const CostReport& report);

// Returns the text with its block "cost" and its block "cost-summary", whichever it has, updated. Throws
// InputError naming `file` if it has neither, or a marker without its counterpart.
std::string replace_cost_blocks(const std::string& text, const CostReport& report, const std::string& file);

}  // namespace penumbra::cost
