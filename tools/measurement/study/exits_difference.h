// Whether exits leave a technique's picture as it is.
#pragma once

#include <string>
#include <vector>

#include "study/results.h"

namespace penumbra::study {

// Exits are lossless: two programs of the same filter round differently, which shows far behind that digit.
inline constexpr double kExitsTolerance = 1e-3;

struct ExitsDifference {
  const Record* exits = nullptr;  // among the results' records, with the one without exits
  const Record* plain = nullptr;
  std::string figure;  // the one that differs most, as in tables
  double with = 0.0;
  double without = 0.0;
};

// Techniques of which an error with exits (RMSE, bias, leaks or false shadow) differs by more than
// kExitsTolerance from that without, of the same scene, light, settings and parameters; in the order of the
// records. What was measured without its other half is not among them.
std::vector<ExitsDifference> differing_exits(const Results& results);

}  // namespace penumbra::study
