#include "study/results.h"

#include <algorithm>

namespace penumbra::study {

bool has_invalid_values(const Results& results) {
  return std::any_of(results.records.begin(), results.records.end(),
                     [](const Record& record) { return record.metrics.invalid > 0; });
}

std::string_view time_kind(const Results& results) {
  return results.is_software ? "CPU time" : "GPU time";
}

}  // namespace penumbra::study
