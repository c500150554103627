// Of a variant that fails, the few keywords that matter.
//
// For each error, the variant with the fewest keywords that has it is compiled again with keywords left out,
// until leaving out any one more loses the error: same file, line, column, message and target. What is tried
// need not be a variant that Unity would build. A variant with n keywords costs between 2 and about n * n / 2
// compilations.
#pragma once

#include <vector>

#include "validation/engine.h"
#include "validation/report.h"
#include "validation/unit.h"

namespace penumbra::validation {

// units[i] is where the records with place first_place + i come from. One entry for each error of a variant
// with keywords, in the order of the records.
std::vector<MinimalKeywords> minimal_keywords(const ValidationReport& report,
                                              const std::vector<CompileUnit>& units, std::size_t first_place,
                                              const EngineOptions& engine);

}  // namespace penumbra::validation
