// Works out and runs many programs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace penumbra::programs {

struct BatchResult {
  int programs = 0;  // number of programs that were run
  int unfit = 0;     // programs whose results the language leaves open
  std::int64_t most_ulps = 0;
  std::vector<std::string> differences;  // messages with the seed and the text of the program
};

// Runs the programs of the seeds from `first` on until there are `count`, on kSets sets of inputs each. A
// program that does not compile is a difference.
BatchResult run_batch(std::uint32_t first, int count);

inline constexpr int kSets = 4;

// The largest distance that is no difference.
inline constexpr std::int64_t kUlps = 2;

}  // namespace penumbra::programs
