#include "lint/assignment_flow.h"

#include <set>
#include <utility>

#include "lint/control_flow.h"
#include "lint/function_assignment.h"

namespace penumbra::lint {

namespace {

// Callees before callers. Recursion, which HLSL forbids, leaves some call without an effect.
std::vector<const Function*> callees_first(const SpirvCode& code) {
  std::vector<const Function*> order;
  std::set<Id> seen;
  std::vector<std::pair<const Function*, std::vector<Id>>> open;
  const auto enter = [&](const Function& function) {
    if (!seen.insert(function.id).second) return;
    std::vector<Id> callees;
    for (const Block& block : function.blocks)
      for (std::size_t i = block.begin; i < block.end; ++i)
        if (code.instructions()[i].op == spv::OpFunctionCall)
          callees.push_back(code.instructions()[i].operands[0]);
    open.emplace_back(&function, std::move(callees));
  };
  for (const Function& root : code.functions()) {
    enter(root);
    while (!open.empty()) {
      if (open.back().second.empty()) {
        order.push_back(open.back().first);
        open.pop_back();
        continue;
      }
      const Function* callee = code.function(open.back().second.back());
      open.back().second.pop_back();
      if (callee != nullptr) enter(*callee);
    }
  }
  return order;
}

// Which parameters are out: SPIR-V does not say, but a caller hands an out parameter a copy it never filled.
std::map<Id, std::vector<bool>> out_parameters(const SpirvCode& code) {
  std::set<Id> stored;
  for (const Instruction& instruction : code.instructions()) {
    if (instruction.op != spv::OpStore) continue;
    const Instruction* target = code.definition(instruction.operands[0]);
    const bool part = target != nullptr && target->op == spv::OpAccessChain;
    stored.insert(part ? target->operands[0] : instruction.operands[0]);
  }
  std::map<Id, std::vector<bool>> out;
  std::set<Id> called;
  for (const Function& function : code.functions()) out[function.id].assign(function.parameters.size(), true);
  for (const Instruction& instruction : code.instructions()) {
    if (instruction.op != spv::OpFunctionCall) continue;
    called.insert(instruction.operands[0]);
    std::vector<bool>& is_out = out[instruction.operands[0]];
    for (std::size_t i = 0; i + 1 < instruction.operands.size() && i < is_out.size(); ++i) {
      const Id argument = instruction.operands[i + 1];
      const bool empty_copy = code.op(argument) == spv::OpVariable && code.name(argument) == "param" &&
                              !stored.contains(argument);
      is_out[i] = is_out[i] && empty_copy;
    }
  }
  for (auto& [id, is_out] : out)
    if (!called.contains(id)) is_out.assign(is_out.size(), false);
  return out;
}

}  // namespace

std::map<Id, AssignmentFindings> assignment_findings(const SpirvCode& code) {
  const std::map<Id, std::vector<bool>> out = out_parameters(code);
  std::map<Id, FunctionEffect> effects;
  std::map<Id, AssignmentFindings> findings;
  for (const Function* function : callees_first(code)) {
    if (function->id == code.entry_function() || function->blocks.empty()) continue;
    if (function->blocks.size() > most_blocks) {
      findings[function->id].too_large = true;
      continue;
    }
    FunctionResult result = function_assignment(code, *function, out.at(function->id), effects);
    findings[function->id] = std::move(result.findings);
    effects[function->id] = std::move(result.effect);
  }
  return findings;
}

}  // namespace penumbra::lint
