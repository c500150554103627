// How much memory a graph takes. Internal to this room.
#pragma once

#include "techniques/pass_graph.h"

namespace penumbra::techniques {

// The texture or buffer with which the graph's ones take more together than a graph may: a manifest of some
// kilobytes would else take all of a machine. Those of the screen and of the map are counted at sizes that
// few exceed. Call it once every texture is known to be right.
void check_memory(const PassGraph& graph);

}  // namespace penumbra::techniques
