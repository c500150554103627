// Works out and runs many programs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "programs/device_run.h"

namespace penumbra::programs {

struct BatchResult {
  int programs = 0;  // number of programs that were run
  int unfit = 0;     // programs whose results the language leaves open
  std::int64_t most_ulps = 0;
  std::vector<std::string> differences;  // messages with the seed and the text of the program
  std::vector<std::string> refusals;     // the same of programs that FXC does not compile
};

// Runs the programs of the seeds from `first` on until there are `count`, on kSets sets of inputs each. A
// program that glslang does not compile is a difference.
BatchResult run_batch(std::uint32_t first, int count, Compiler compiler);

inline constexpr int kSets = 4;

// The largest distance that is no difference.
inline constexpr std::int64_t kUlps = 2;

}  // namespace penumbra::programs
