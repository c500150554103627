// Generates the Poisson disks. The same size gives the same bits on every IEEE machine: the points are
// computed from integers with + - * / and sqrt. (The star discrepancy that selects among starts uses atan;
// its last bit would matter only in a tie.)
//
// 1. Best-candidate dart throwing (Mitchell 1991) with a fixed integer generator: a Poisson disk.
//
// 2. A short gradient descent on the half-plane error (disk_quality.h). The gradient of each point is a
// repulsion from every other point by a unit vector / N and an attraction by the disk's own mean unit vector.
// Eighty steps take all but 2 % of the gain; more would settle the points into concentric rings.
//
// 3. Of 96 starts the one with the smallest product of half-plane error and star discrepancy.
//
// 4. Greedy order: the next point is the one that gives the smallest half-plane error, so a shader may stop
// early.
//
// `before_start` is called before each start, every few milliseconds, and may throw to end the work.
#pragma once

#include <functional>

#include "parameters/disk.h"

namespace penumbra::parameters {

// `before_start` is called before each start, every few milliseconds, and may throw to end the work.
DiskPoints generate_poisson_disk(int count, const std::function<void()>& before_start = {});

}  // namespace penumbra::parameters
