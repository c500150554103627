// The part of a run that one of several machines processes.
#pragma once

#include <cstddef>
#include <vector>

#include "validation/unit.h"

namespace penumbra::validation {

struct Shard {
  unsigned index = 1;  // counted from 1
  unsigned count = 1;
};

// Returns the indices in `units` of those that belong to the shard, ascending. Every unit belongs to exactly
// one shard, independent of the order of units, of the other units, and of the checkout's location (as long
// as the units have the same paths below their common folder): a shard's cache remains useful when units are
// added or removed. The stages of a variant are in one shard unless one of them has keywords of its own. The
// sizes of shards vary like random draws, by about the square root of their size.
std::vector<std::size_t> units_of_shard(const std::vector<CompileUnit>& units, const Shard& shard);

}  // namespace penumbra::validation
