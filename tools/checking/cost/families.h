// The AMD GPU families that Mesa's RADV can compile for without the hardware, by the names Mesa gives them.
//
// As Mesa 22.3 spells them in RADV_FORCE_FAMILY; other versions have more, fewer or other names, and the
// driver decides. These are for tables and for "did you mean".
#pragma once

#include <span>
#include <string>
#include <vector>

namespace penumbra::cost {

struct KnownFamily {
  const char* name;
  const char* architecture;
};

std::span<const KnownFamily> known_families();  // oldest first
std::vector<std::string> known_family_names();

// One each of three architectures that are common in games: GCN 4, RDNA 2, RDNA 3.
std::vector<std::string> default_families();

}  // namespace penumbra::cost
