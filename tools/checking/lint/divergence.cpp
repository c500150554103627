#include "lint/divergence.h"

#include <algorithm>
#include <utility>

namespace penumbra::lint {
namespace {

bool is_branch(spv::Op op) {
  return op == spv::OpBranchConditional || op == spv::OpSwitch;
}

bool is_atomic(spv::Op op) {
  return op >= spv::OpAtomicLoad && op <= spv::OpAtomicXor;
}

}  // namespace

Divergence::Divergence(const spirv::Code& code, const spirv::Function& function, Together together)
    : code_(code),
      function_(function),
      together_(together),
      flow_(control_flow(code, function)),
      depends_(control_dependence(code, function, flow_)),
      node_of_(code.id_bound(), no_node),
      varies_(code.id_bound()),
      branch_varies_(function.blocks.size()),
      runs_apart_(function.blocks.size()) {
  for (std::size_t node = 0; node < function.blocks.size(); ++node)
    for (std::size_t i = function.blocks[node].begin; i < function.blocks[node].end; ++i)
      node_of_[code.instructions()[i].result] = node;
  for (const spirv::Id parameter : function.parameters) varies_[parameter] = true;
  find_loops();
  propagate();
}

void Divergence::find_loops() {
  for (const std::size_t header : flow_.order) {
    std::vector<bool> body = loop_body(flow_, header);
    if (!body.empty()) loops_.push_back({header, std::move(body), false});
  }
}

void Divergence::propagate() {
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::size_t node : flow_.order) {
      const spirv::Block& block = function_.blocks[node];
      for (std::size_t i = block.begin; i < block.end; ++i) {
        const spirv::Instruction& instruction = code_.instructions()[i];
        if (is_branch(instruction.op) && !branch_varies_[node] && varies(instruction.operands[0])) {
          branch_varies_[node] = true;
          changed = true;
        }
        if (instruction.result == 0 || varies_[instruction.result] || !varies_at(instruction, node)) continue;
        varies_[instruction.result] = true;
        changed = true;
      }
    }
    mark_control();
    changed = mark_stores() || changed;
    changed = mark_loops() || changed;
  }
}

bool Divergence::varies_at(const spirv::Instruction& instruction, std::size_t node) const {
  if (instruction.op == spv::OpVariable) return false;  // see mark_stores
  if (source_varies(instruction)) return true;
  if (instruction.op == spv::OpPhi) return phi_varies(instruction, node);
  if (instruction.op == spv::OpLoad) {
    const spirv::Id variable = root(instruction.operands[0]);
    if (varies(variable)) return true;
  }
  const std::span<const spirv::Id> ids = code_.ids(instruction);
  return std::any_of(ids.begin(), ids.end(), [&](spirv::Id id) { return varies(id); }) ||
         used_behind_loop(instruction, node);
}

bool Divergence::source_varies(const spirv::Instruction& instruction) const {
  if (is_atomic(instruction.op) || instruction.op == spv::OpFunctionCall) return true;
  if (instruction.op != spv::OpLoad) return false;
  const spirv::Id variable = root(instruction.operands[0]);
  const spirv::Instruction* definition = code_.definition(variable);
  return definition != nullptr && code_.storage_class(definition->type) == spv::StorageClassInput &&
         input_varies(variable);
}

bool Divergence::input_varies(spirv::Id variable) const {
  const std::optional<std::uint32_t> built_in = code_.decoration(variable, spv::DecorationBuiltIn);
  if (together_ == Together::group)
    return !built_in || (*built_in != spv::BuiltInWorkgroupId && *built_in != spv::BuiltInNumWorkgroups &&
                         *built_in != spv::BuiltInWorkgroupSize && *built_in != spv::BuiltInSubgroupSize);
  const bool of_primitive =
      built_in && (*built_in == spv::BuiltInFrontFacing || *built_in == spv::BuiltInPrimitiveId ||
                   *built_in == spv::BuiltInViewIndex || *built_in == spv::BuiltInLayer ||
                   *built_in == spv::BuiltInViewportIndex);
  return !of_primitive && !code_.decoration(variable, spv::DecorationFlat);
}

// Returns whether the variable is a thread's own, as opposed to memory that all threads see.
bool Divergence::is_own_memory(spirv::Id variable) const {
  const std::optional<spv::StorageClass> storage = code_.storage_class(code_.definition(variable)->type);
  return storage == spv::StorageClassFunction || storage == spv::StorageClassPrivate;
}

// Paths that join here have different values, and a divergent condition decides which path a pixel took.
bool Divergence::phi_varies(const spirv::Instruction& phi, std::size_t node) const {
  bool same = true;
  for (std::size_t i = 0; i + 1 < phi.operands.size(); i += 2) {
    if (varies(phi.operands[i])) return true;
    same = same && phi.operands[i] == phi.operands[0];
  }
  if (same) return false;
  const auto& here = depends_[node];
  for (const std::size_t from : flow_.predecessors[node]) {
    if (!flow_.reachable(from)) continue;
    for (const std::size_t branch : depends_[from]) {
      if (std::find(here.begin(), here.end(), branch) != here.end()) continue;
      if (branch_varies_[branch] || (runs_apart_[branch] && !runs_apart_[node])) return true;
    }
  }
  return false;
}

// A value that changes with each iteration diverges behind a loop with a divergent exit.
bool Divergence::used_behind_loop(const spirv::Instruction& instruction, std::size_t node) const {
  for (const Loop& loop : loops_) {
    if (!loop.left_at_different_times || loop.body[node]) continue;
    for (const spirv::Id id : code_.ids(instruction))
      if (node_of_[id] != no_node && loop.body[node_of_[id]]) return true;
  }
  return false;
}

void Divergence::mark_control() {
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::size_t node : flow_.order) {
      if (runs_apart_[node]) continue;
      runs_apart_[node] = std::any_of(depends_[node].begin(), depends_[node].end(), [&](std::size_t branch) {
        return branch_varies_[branch] || (branch != node && runs_apart_[branch]);
      });
      changed = changed || runs_apart_[node];
    }
  }
}

// These variables remain in memory after conversion to SSA: arrays with dynamic indices.
bool Divergence::mark_stores() {
  bool changed = false;
  for (const std::size_t node : flow_.order) {
    const spirv::Block& block = function_.blocks[node];
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const spirv::Instruction& instruction = code_.instructions()[i];
      if (instruction.op != spv::OpStore) continue;
      const spirv::Id variable = root(instruction.operands[0]);
      if (varies(variable) || code_.op(variable) != spv::OpVariable) continue;
      if (together_ == Together::group && !is_own_memory(variable)) continue;
      if (!varies(instruction.operands[1]) && !varies(instruction.operands[0]) && !runs_apart_[node])
        continue;
      varies_[variable] = true;
      changed = true;
    }
  }
  return changed;
}

bool Divergence::mark_loops() {
  bool changed = false;
  for (Loop& loop : loops_) {
    for (const std::size_t node : flow_.order) {
      if (loop.left_at_different_times || !loop.body[node] || !branch_varies_[node]) continue;
      loop.left_at_different_times = loop_left_by(node, loop.header) == loop.header;
      changed = changed || loop.left_at_different_times;
    }
  }
  return changed;
}

spirv::Id Divergence::root(spirv::Id pointer) const {
  const spirv::Instruction* definition = code_.definition(pointer);
  while (definition != nullptr &&
         (definition->op == spv::OpAccessChain || definition->op == spv::OpInBoundsAccessChain ||
          definition->op == spv::OpCopyObject || definition->op == spv::OpImageTexelPointer))
    definition = code_.definition(definition->operands[0]);
  return definition == nullptr ? 0 : definition->result;
}

std::vector<std::size_t> Divergence::varying_branches_over(std::size_t node) const {
  std::vector<std::size_t> found;
  std::vector<bool> seen(function_.blocks.size());
  std::vector<std::size_t> waiting = depends_[node];
  while (!waiting.empty()) {
    const std::size_t branch = waiting.back();
    waiting.pop_back();
    if (seen[branch]) continue;
    seen[branch] = true;
    if (branch_varies_[branch]) found.push_back(branch);
    waiting.insert(waiting.end(), depends_[branch].begin(), depends_[branch].end());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// A branch is a loop exit if the loop's header is control-dependent on it: it decides about the next
// iteration.
std::size_t Divergence::loop_left_by(std::size_t branch, std::size_t node) const {
  for (std::size_t inner = loops_.size(); inner-- > 0;) {  // inner loops come later
    const Loop& loop = loops_[inner];
    if (!loop.body[branch] || !loop.body[node]) continue;
    const auto& decides = depends_[loop.header];
    if (std::find(decides.begin(), decides.end(), branch) != decides.end()) return loop.header;
  }
  return no_node;
}

bool is_barrier(const spirv::Instruction& instruction) {
  return instruction.op == spv::OpControlBarrier;
}

std::string place_of_condition(const LintedCode& linted, const spirv::Function& function, std::size_t branch,
                               spirv::Place from) {
  const spirv::Instruction& end = terminator(linted.code, function.blocks[branch]);
  spirv::Place place = end.place;
  const spirv::Instruction* condition = linted.code.definition(end.operands[0]);
  if (place.line == 0 && condition != nullptr) place = condition->place;
  return place_in_words(linted, place, from);
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
