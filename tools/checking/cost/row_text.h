// Parts of a row as text, for every form a report has. Internal to this folder.
#pragma once

#include <string>
#include <vector>

#include "cost/cost_report.h"

namespace penumbra::cost {

std::vector<std::string> technique_names(const CostRow& row);  // each once, in order; empty for a user's file
std::string keywords_text(const CostRow& row);                 // " +A +B or none", or empty
std::string figure_text(const Figure& figure);                 // "-" if the driver gave no figure

// Returns the columns of a family's table: every figure but those that are 0 in all its rows, the lanes of a
// subgroup and the counts of SPIR-V. absent_figures() names those that are 0 in all tables ("" when there are
// none).
std::vector<std::string> column_heads(const CostReport& report, const std::string& family);
std::vector<std::string> column_cells(const CostReport& report, const CostRow& row);
std::string absent_figures(const CostReport& report);

}  // namespace penumbra::cost
