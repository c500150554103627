// The AMD GPU families for which shaders are compiled, by the names that Mesa's RADV gives them, and
// Direct3D's bytecode.
//
// The names are those of Mesa 22.3 in RADV_FORCE_FAMILY. Other versions have more, fewer or other names, and
// the driver decides. This list is for tables and for "did you mean".
#pragma once

#include <span>
#include <string>
#include <vector>

namespace penumbra::cost {

struct KnownFamily {
  const char* name;
  const char* architecture;
};

std::span<const KnownFamily> known_families();  // RADV's families, oldest first
std::vector<std::string> known_family_names();

// FXC's bytecode, before a driver compiles it: the figures that Unity's inspector shows for Direct3D 11.
inline constexpr KnownFamily direct3d_family{"d3d11", "Direct3D bytecode"};

// Returns one family each of three architectures that are common in games: GCN 4, RDNA 2, RDNA 3.
std::vector<std::string> default_families();

}  // namespace penumbra::cost
