#include "lint/assignment_flow.h"

#include <set>
#include <utility>

#include "lint/control_flow.h"
#include "lint/function_assignment.h"

namespace penumbra::lint {

namespace {

// Callees come before callers. With recursion, which HLSL forbids, some call has no known effect.
std::vector<const spirv::Function*> callees_first(const spirv::Code& code) {
  std::vector<const spirv::Function*> order;
  std::set<spirv::Id> seen;
  std::vector<std::pair<const spirv::Function*, std::vector<spirv::Id>>> open;
  const auto enter = [&](const spirv::Function& function) {
    if (!seen.insert(function.id).second) return;
    std::vector<spirv::Id> callees;
    for (const spirv::Block& block : function.blocks)
      for (std::size_t i = block.begin; i < block.end; ++i)
        if (code.instructions()[i].op == spv::OpFunctionCall)
          callees.push_back(code.instructions()[i].operands[0]);
    open.emplace_back(&function, std::move(callees));
  };
  for (const spirv::Function& root : code.functions()) {
    enter(root);
    while (!open.empty()) {
      if (open.back().second.empty()) {
        order.push_back(open.back().first);
        open.pop_back();
        continue;
      }
      const spirv::Function* callee = code.function(open.back().second.back());
      open.back().second.pop_back();
      if (callee != nullptr) enter(*callee);
    }
  }
  return order;
}

// Returns which parameters are out: SPIR-V does not record it, but a caller passes an uninitialised copy for
// an out parameter.
std::map<spirv::Id, std::vector<bool>> out_parameters(const spirv::Code& code) {
  std::set<spirv::Id> stored;
  for (const spirv::Instruction& instruction : code.instructions()) {
    if (instruction.op != spv::OpStore) continue;
    const spirv::Instruction* target = code.definition(instruction.operands[0]);
    const bool part = target != nullptr && target->op == spv::OpAccessChain;
    stored.insert(part ? target->operands[0] : instruction.operands[0]);
  }
  std::map<spirv::Id, std::vector<bool>> out;
  std::set<spirv::Id> called;
  for (const spirv::Function& function : code.functions())
    out[function.id].assign(function.parameters.size(), true);
  for (const spirv::Instruction& instruction : code.instructions()) {
    if (instruction.op != spv::OpFunctionCall) continue;
    called.insert(instruction.operands[0]);
    std::vector<bool>& is_out = out[instruction.operands[0]];
    for (std::size_t i = 0; i + 1 < instruction.operands.size() && i < is_out.size(); ++i) {
      const spirv::Id argument = instruction.operands[i + 1];
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

std::map<spirv::Id, AssignmentFindings> assignment_findings(const spirv::Code& code) {
  const std::map<spirv::Id, std::vector<bool>> out = out_parameters(code);
  std::map<spirv::Id, FunctionEffect> effects;
  std::map<spirv::Id, AssignmentFindings> findings;
  for (const spirv::Function* function : callees_first(code)) {
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
