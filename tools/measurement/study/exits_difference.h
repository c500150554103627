// Whether exits leave a technique's picture as it is.
#pragma once

#include <vector>

#include "study/results.h"

namespace penumbra::study {

// Of rmse_all and of rmse_penumbra. Exits are lossless: two programs of the same filter round differently,
// which shows far behind that digit.
inline constexpr double kExitsTolerance = 1e-3;

struct ExitsDifference {
  const Record* exits = nullptr;  // among the results' records, with the one without exits
  const Record* plain = nullptr;
};

// Techniques whose error with exits is not their error without, of the same scene, light, settings and
// parameters; in the order of the records. What was measured alone is not among them.
std::vector<ExitsDifference> differing_exits(const Results& results);

}  // namespace penumbra::study
