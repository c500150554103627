#include "lint/control_flow.h"

#include <algorithm>
#include <map>
#include <utility>

namespace penumbra::lint {

namespace {

// Returns the targets that a terminator can reach.
std::vector<spirv::Id> targets(const spirv::Code& code, const spirv::Instruction& end) {
  switch (end.op) {
    case spv::OpBranch:
      return {end.operands[0]};
    case spv::OpBranchConditional: {
      const spv::Op condition = code.op(end.operands[0]);
      if (condition == spv::OpConstantTrue) return {end.operands[1]};
      if (condition == spv::OpConstantFalse) return {end.operands[2]};
      return {end.operands[1], end.operands[2]};
    }
    case spv::OpSwitch: {
      std::vector<spirv::Id> all{end.operands[1]};
      for (std::size_t i = 3; i < end.operands.size(); i += 2) all.push_back(end.operands[i]);
      return all;
    }
    default:
      return {};
  }
}

std::size_t nearer(const std::vector<std::size_t>& dominator, const std::vector<std::size_t>& rank,
                   std::size_t a, std::size_t b) {
  while (a != b) {
    while (rank[a] > rank[b]) a = dominator[a];
    while (rank[b] > rank[a]) b = dominator[b];
  }
  return a;
}

// Returns the node at which execution continues after the innermost condition or loop around a node.
std::size_t end_of_construct(const ControlFlow& flow, std::size_t node) {
  for (std::size_t at = node;; at = flow.dominator[at]) {
    const std::size_t merge = flow.merge[at];
    if (merge != no_node && merge != node && at != node && !flow.dominates(merge, node)) return merge;
    if (flow.dominator[at] == at) return no_node;
  }
}

// Returns the graph with one added exit, a successor of every end and, for infinite loops, of their headers.
Graph with_exit(const spirv::Code& code, const spirv::Function& function, const ControlFlow& flow) {
  Graph graph = flow.successors;
  const std::size_t exit = graph.size();
  graph.emplace_back();
  for (const std::size_t node : flow.order) {
    const spv::Op end = terminator(code, function.blocks[node]).op;
    const bool stops = graph[node].empty();
    const std::size_t on = stops && end == spv::OpKill ? end_of_construct(flow, node) : no_node;
    if (on != no_node) {
      graph[node].push_back(on);
    } else if (stops) {
      graph[node].push_back(exit);
    }
  }
  const std::vector<std::size_t> ends = reverse_postorder(reversed(graph), exit);
  std::vector<bool> finishes(graph.size());
  for (const std::size_t node : ends) finishes[node] = true;
  for (const std::size_t node : flow.order)
    if (!finishes[node] && flow.merge[node] != no_node) graph[node].push_back(exit);
  return graph;
}

}  // namespace

bool ControlFlow::dominates(std::size_t above, std::size_t below) const {
  if (!reachable(above) || !reachable(below)) return false;
  while (depth[below] > depth[above]) below = dominator[below];
  return above == below;
}

bool ControlFlow::encloses(std::size_t header, std::size_t node) const {
  return merge[header] != no_node && header != node && dominates(header, node) &&
         !dominates(merge[header], node);
}

const spirv::Instruction& terminator(const spirv::Code& code, const spirv::Block& block) {
  return code.instructions()[block.end - 1];
}

Graph reversed(const Graph& graph) {
  Graph back(graph.size());
  for (std::size_t from = 0; from < graph.size(); ++from)
    for (const std::size_t to : graph[from]) back[to].push_back(from);
  return back;
}

std::vector<std::size_t> reverse_postorder(const Graph& graph, std::size_t entry) {
  std::vector<std::size_t> order;
  std::vector<bool> seen(graph.size());
  std::vector<std::pair<std::size_t, std::size_t>> open{{entry, 0}};  // node, its next successor
  seen[entry] = true;
  while (!open.empty()) {
    auto& [node, next] = open.back();
    if (next == graph[node].size()) {
      order.push_back(node);
      open.pop_back();
      continue;
    }
    const std::size_t to = graph[node][next++];
    if (seen[to]) continue;
    seen[to] = true;
    open.emplace_back(to, 0);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

std::vector<std::size_t> immediate_dominators(const Graph& graph, std::size_t entry) {
  const std::vector<std::size_t> order = reverse_postorder(graph, entry);
  const Graph back = reversed(graph);
  std::vector<std::size_t> rank(graph.size(), no_node);
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
  std::vector<std::size_t> dominator(graph.size(), no_node);
  dominator[entry] = entry;
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::size_t node : order) {
      if (node == entry) continue;
      std::size_t found = no_node;
      for (const std::size_t from : back[node])
        if (dominator[from] != no_node)
          found = found == no_node ? from : nearer(dominator, rank, from, found);
      changed = changed || dominator[node] != found;
      dominator[node] = found;
    }
  }
  return dominator;
}

ControlFlow control_flow(const spirv::Code& code, const spirv::Function& function) {
  std::map<spirv::Id, std::size_t> node_of;
  for (std::size_t i = 0; i < function.blocks.size(); ++i) node_of[function.blocks[i].label] = i;
  ControlFlow flow;
  flow.successors.resize(function.blocks.size());
  flow.merge.assign(function.blocks.size(), no_node);
  for (std::size_t i = 0; i < function.blocks.size(); ++i) {
    const spirv::Block& block = function.blocks[i];
    for (const spirv::Id target : targets(code, terminator(code, block)))
      flow.successors[i].push_back(node_of.at(target));
    if (block.end - block.begin < 2) continue;
    const spirv::Instruction& before = code.instructions()[block.end - 2];
    if (before.op == spv::OpSelectionMerge || before.op == spv::OpLoopMerge)
      flow.merge[i] = node_of.at(before.operands[0]);
  }
  flow.predecessors = reversed(flow.successors);
  flow.order = reverse_postorder(flow.successors, 0);
  flow.dominator = immediate_dominators(flow.successors, 0);
  flow.depth.assign(function.blocks.size(), 0);
  for (const std::size_t node : flow.order)
    if (node != 0) flow.depth[node] = flow.depth[flow.dominator[node]] + 1;
  return flow;
}

Graph control_dependence(const spirv::Code& code, const spirv::Function& function, const ControlFlow& flow) {
  const Graph graph = with_exit(code, function, flow);
  const std::size_t exit = graph.size() - 1;
  const std::vector<std::size_t> after = immediate_dominators(reversed(graph), exit);  // post-dominators
  Graph depends(graph.size());
  for (const std::size_t branch : flow.order) {
    if (graph[branch].size() < 2 || after[branch] == no_node) continue;
    for (const std::size_t way : graph[branch])
      for (std::size_t node = way; node != after[branch] && node != exit && after[node] != no_node;
           node = after[node])
        if (depends[node].empty() || depends[node].back() != branch) depends[node].push_back(branch);
  }
  depends.resize(function.blocks.size());
  return depends;
}

}  // namespace penumbra::lint
