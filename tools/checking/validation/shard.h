// The part of a run that one machine of several takes.
#pragma once

#include <cstddef>
#include <vector>

#include "validation/unit.h"

namespace penumbra::validation {

struct Shard {
  unsigned index = 1;  // from 1
  unsigned count = 1;
};

// The places in `units` of those that belong to the shard, ascending. Every unit belongs to exactly one.
// Which one does not depend on the order of units, on the other units, or on where the checkout lies (as long
// as the units lie in the same folders below their common one): a shard's cache stays of use when units come
// and go. Shards differ in size as random draws do, by about the square root of their size.
std::vector<std::size_t> units_of_shard(const std::vector<CompileUnit>& units, const Shard& shard);

}  // namespace penumbra::validation
