// The report's table of all records.
#pragma once

#include <string>

#include "study/results.h"

namespace penumbra::study {

// One row per record; the report's script sorts it. Empty without records.
std::string record_table(const Results& results);

}  // namespace penumbra::study
