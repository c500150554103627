// A function's control-flow graph in which the first iteration of loops that certainly run is peeled.
// Internal to this folder.
//
// `for (i = 0; i < 4; ++i)` looks to a path analysis as if its body might be skipped. If constant folding
// decides the condition for the first iteration, the test before that iteration becomes a separate node whose
// only successor is the body.
#pragma once

#include <cstddef>
#include <vector>

#include "lint/control_flow.h"

namespace penumbra::lint {

struct Paths {
  std::vector<std::size_t> block;  // block of each node; two nodes may have one block
  Graph successors;
  Graph predecessors;
  std::vector<std::size_t> order;  // reachable nodes, reverse postorder
};

Paths paths_of(const spirv::Code& code, const spirv::Function& function);

}  // namespace penumbra::lint
