// A function's blocks as paths through them, with loops that surely run once shown as such.
// Internal to this room.
//
// `for (i = 0; i < 4; ++i)` looks to a path analysis as if its body might be skipped. Where the condition can
// be computed from constants for the first round, the test before the first round is a node of its own that
// leads into the body alone.
#pragma once

#include <cstddef>
#include <vector>

#include "lint/control_flow.h"

namespace penumbra::lint {

struct Paths {
  std::vector<std::size_t> block;  // by node; two nodes may stand for one block
  Graph successors;
  Graph predecessors;
  std::vector<std::size_t> order;  // reachable nodes, reverse postorder
};

Paths paths_of(const spirv::Code& code, const spirv::Function& function);

}  // namespace penumbra::lint
