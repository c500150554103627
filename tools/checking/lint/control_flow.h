// The control-flow graph of a SPIR-V function, its dominators and control dependence. Internal to this
// folder.
//
// Nodes are the indices of Function::blocks. Branches on a constant have one successor. Dominators follow
// Cooper, Harvey and Kennedy, "A Simple, Fast Dominance Algorithm" (2001); control dependence follows
// Ferrante, Ottenstein and Warren, "The Program Dependence Graph and Its Use in Optimization" (1987).
#pragma once

#include <cstddef>
#include <vector>

#include "spirv/code.h"

namespace penumbra::lint {

using Graph = std::vector<std::vector<std::size_t>>;  // successors by node

constexpr std::size_t no_node = static_cast<std::size_t>(-1);

// Modules with more basic blocks are not analysed: neither our algorithms nor SPIRV-Tools' are linear in the
// worst case.
constexpr std::size_t most_blocks = 4'000;

struct ControlFlow {
  Graph successors;
  Graph predecessors;
  std::vector<std::size_t> order;  // reachable nodes in reverse postorder, the entry first
  // The immediate dominator of each node: the entry's is itself; no_node where unreachable.
  std::vector<std::size_t> dominator;
  std::vector<std::size_t> merge;  // for each node: the merge block that it declares, or no_node
  std::vector<std::size_t> depth;  // depth in the dominator tree

  bool reachable(std::size_t node) const { return dominator[node] != no_node; }
  bool dominates(std::size_t above, std::size_t below) const;
  // Returns whether the header declares a merge block, and the node is in the condition or loop before it.
  bool encloses(std::size_t header, std::size_t node) const;
};

ControlFlow control_flow(const spirv::Code& code, const spirv::Function& function);

// Returns the last instruction of a block.
const spirv::Instruction& terminator(const spirv::Code& code, const spirv::Block& block);

Graph reversed(const Graph& graph);
std::vector<std::size_t> reverse_postorder(const Graph& graph, std::size_t entry);
std::vector<std::size_t> immediate_dominators(const Graph& graph, std::size_t entry);

// Returns for every node the branches on which it is directly control-dependent: one successor always leads
// to it, another need not. `discard` is not an exit: Direct3D and Vulkan's demotion keep the invocation for
// derivatives, so a block that ends in OpKill counts as continuing where its condition ends.
Graph control_dependence(const spirv::Code& code, const spirv::Function& function, const ControlFlow& flow);

}  // namespace penumbra::lint
