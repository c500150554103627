// Makes the Poisson disks. Same size, same bits, on every IEEE machine: the points come from integers, + - *
// / and sqrt. (The star discrepancy that chooses among starts uses atan; its last bit would have to break a
// tie.)
//
// 1. Best-candidate dart throwing (Mitchell 1991) with a fixed integer generator: a Poisson disk.
// 2. A short descent on the half-plane error (disk_quality.h). Its gradient has a plain meaning: each point
// is
//    pushed from every other by a unit vector / N and drawn back by the disk's own mean unit vector. Eighty
//    steps take all but 2 % of the gain; more would settle the points into concentric rings.
// 3. Of 96 starts the one with the smallest product of half-plane error and star discrepancy.
// 4. Greedy order: the next point is the one that leaves the smallest half-plane error, so a shader may stop
//    early.
#pragma once

#include <functional>

#include "parameters/disk.h"

namespace penumbra::parameters {

// `before_start` is called before each start, every few milliseconds, and may throw to end the work.
DiskPoints generate_poisson_disk(int count, const std::function<void()>& before_start = {});

}  // namespace penumbra::parameters
