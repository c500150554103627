// The places of the cascades' tiles in the shadow map.
#pragma once

#include <array>
#include <vector>

namespace penumbra::resolve {

struct MapLayout {
  int width = 0;  // texels, all cascades
  int height = 0;
  int tile = 0;                             // side of a cascade's square tile
  std::vector<std::array<int, 2>> origins;  // x, y of each cascade's tile
};

}  // namespace penumbra::resolve
