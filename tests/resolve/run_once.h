// Options of tests that run a graph once, untimed: without counts of fetches, or with them.
#pragma once

#include "resolve/graph_runner.h"

namespace penumbra::resolve {

inline constexpr RunOptions kOnce{.noise_seeds = 1, .timing_repeats = 0};
inline constexpr RunOptions kCountedOnce{.noise_seeds = 1, .timing_repeats = 0, .count_fetches = true};

}  // namespace penumbra::resolve
