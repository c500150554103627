// Minimises the keywords of failing variants.
//
// For each error, the variant with the fewest keywords that has it is compiled again with keywords removed,
// until removing any other one loses the error: same file, line, column, message and target. The candidates
// need not be variants that Unity would build. A variant with n keywords costs between 2 and about n * n / 2
// compilations.
#pragma once

#include <vector>

#include "validation/engine.h"
#include "validation/report.h"
#include "validation/unit.h"

namespace penumbra::validation {

// units[i] is the unit of the records with place first_place + i. The result has one entry for each error of
// a variant with keywords, in the order of the records.
std::vector<MinimalKeywords> minimal_keywords(const ValidationReport& report,
                                              const std::vector<CompileUnit>& units, std::size_t first_place,
                                              const EngineOptions& engine);

}  // namespace penumbra::validation
