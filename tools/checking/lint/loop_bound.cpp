#include "lint/loop_bound.h"

#include <algorithm>

namespace penumbra::lint {

namespace {

constexpr int deepest_condition = 8;

bool is_constant(const spirv::Code& code, spirv::Id id) {
  const spv::Op op = code.op(id);
  return op == spv::OpConstant || op == spv::OpConstantNull || op == spv::OpConstantTrue ||
         op == spv::OpConstantFalse;
}

bool compares_with_constant(const spirv::Code& code, spirv::Id condition, int depth) {
  const spirv::Instruction* of = code.definition(condition);
  if (of == nullptr || depth > deepest_condition) return true;
  const bool is_comparison = of->op >= spv::OpIEqual && of->op <= spv::OpFUnordGreaterThanEqual;
  if (is_comparison) return is_constant(code, of->operands[0]) || is_constant(code, of->operands[1]);
  if (of->op == spv::OpLogicalNot) return compares_with_constant(code, of->operands[0], depth + 1);
  if (of->op == spv::OpLogicalAnd || of->op == spv::OpLogicalOr)
    return compares_with_constant(code, of->operands[0], depth + 1) ||
           compares_with_constant(code, of->operands[1], depth + 1);
  return false;
}

}  // namespace

bool has_constant_bound(const spirv::Code& code, const spirv::Function& function, const ControlFlow& flow,
                        const std::vector<bool>& body) {
  for (const std::size_t node : flow.order) {
    if (!body[node]) continue;
    const spirv::Instruction& end = terminator(code, function.blocks[node]);
    if (end.op != spv::OpBranchConditional) continue;
    // In `if (c) break;` the branch goes to a separate block, which is not part of the loop either.
    const bool leaves = std::any_of(flow.successors[node].begin(), flow.successors[node].end(),
                                    [&](std::size_t to) { return !body[to]; });
    if (leaves && compares_with_constant(code, end.operands[0], 0)) return true;
  }
  return false;
}

// The nodes of a natural loop reach a back edge without passing the header.
std::vector<bool> loop_body(const ControlFlow& flow, std::size_t header) {
  std::vector<std::size_t> waiting;
  for (const std::size_t from : flow.predecessors[header])
    if (flow.dominates(header, from)) waiting.push_back(from);
  if (waiting.empty()) return {};
  std::vector<bool> body(flow.successors.size());
  body[header] = true;
  while (!waiting.empty()) {
    const std::size_t node = waiting.back();
    waiting.pop_back();
    if (body[node]) continue;
    body[node] = true;
    for (const std::size_t from : flow.predecessors[node])
      if (flow.reachable(from)) waiting.push_back(from);
  }
  return body;
}

}  // namespace penumbra::lint
