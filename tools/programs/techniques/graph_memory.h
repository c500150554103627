// A limit of the memory that a graph takes. Internal to this folder.
#pragma once

#include "techniques/pass_graph.h"

namespace penumbra::techniques {

// Refuses the texture or buffer with which the graph's ones take more together than a graph may: a manifest
// of some kilobytes could otherwise take all of a machine. Those of the screen and of the map count at sizes
// that few exceed. It must be called once every texture is known to be right.
void check_memory(const PassGraph& graph);

}  // namespace penumbra::techniques
