// The report's table of figures: the figures that decide stand in columns, the rest of a record in a row
// below it.
#pragma once

#include <string>
#include <vector>

#include "study/report.h"
#include "study/results.h"

namespace penumbra::study {

// Returns the table's frame and the data from which the report's script draws it: for each record a row of
// its headline figures, and all other figures of it, which are folded away. A row leads to its pictures where
// there are some. Columns without any figure are left out. The text is empty without records.
std::string record_table(const Results& results, const std::vector<PictureRow>& pictures);

}  // namespace penumbra::study
