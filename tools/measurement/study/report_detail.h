// All details of one record, or of a mean, beyond its headline figures.
#pragma once

#include <string>

#include "study/results.h"

namespace penumbra::study {

// Returns definition lists under headings; figures that were not measured are left out. about_id is the id of
// the part that names the technique and its parameters, which the report also shows as a tooltip.
std::string record_detail(const Results& results, const Record& record, const std::string& about_id);

// Returns the same of a mean over scenes. `any` is one of its records, which share parameters and settings.
std::string mean_detail(const Results& results, const Record& any, const std::string& about_id);

}  // namespace penumbra::study
