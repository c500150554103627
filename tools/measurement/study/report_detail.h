// All details of one record, or of a mean, beyond its headline figures.
#pragma once

#include <nlohmann/json.hpp>

#include "study/results.h"

namespace penumbra::study {

// Returns groups of terms and their texts, {"title": ..., "entries": [[term, text], ...]}; figures that were
// not measured are left out. The first group names the technique and its parameters.
nlohmann::ordered_json record_detail(const Results& results, const Record& record);

// Returns the same of a mean over scenes. `any` is one of its records, which share parameters and settings.
nlohmann::ordered_json mean_detail(const Results& results, const Record& any);

}  // namespace penumbra::study
