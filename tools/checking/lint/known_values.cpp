#include "lint/known_values.h"

#include <set>

namespace penumbra::lint {

spirv::Id base_of(const spirv::Code& code, spirv::Id pointer) {
  const spirv::Instruction* chain = code.definition(pointer);
  while (chain != nullptr && chain->op == spv::OpAccessChain) {
    pointer = chain->operands[0];
    chain = code.definition(pointer);
  }
  return pointer;
}

KnownValues::KnownValues(const spirv::Code& code) : code_(code) {
  for (const spirv::Instruction& instruction : code.instructions())
    if (instruction.op == spv::OpStore)
      stored_[base_of(code, instruction.operands[0])].push_back(instruction.operands[1]);
  const std::map<spirv::Id, std::vector<spirv::Id>> in_callees = stored_;
  for (const spirv::Instruction& call : code.instructions()) {
    const spirv::Function* callee =
        call.op == spv::OpFunctionCall ? code.function(call.operands[0]) : nullptr;
    if (callee == nullptr) continue;
    for (std::size_t i = 0; i < callee->parameters.size() && i + 1 < call.operands.size(); ++i) {
      const spirv::Id argument = call.operands[i + 1];
      given_[callee->parameters[i]].push_back(argument);
      const auto written = in_callees.find(callee->parameters[i]);
      if (written == in_callees.end()) continue;
      std::vector<spirv::Id>& to = stored_[base_of(code, argument)];
      to.insert(to.end(), written->second.begin(), written->second.end());
    }
  }
}

bool KnownValues::comes_from_outside(const spirv::Instruction& definition) const {
  if (definition.op == spv::OpFunctionParameter) return !given_.contains(definition.result);
  if (definition.op != spv::OpVariable) return false;
  const std::optional<spv::StorageClass> storage = code_.storage_class(definition.type);
  return storage != spv::StorageClassFunction && storage != spv::StorageClassPrivate;
}

bool KnownValues::known(spirv::Id value) const {
  std::vector<spirv::Id> waiting{value};
  std::set<spirv::Id> seen;
  while (!waiting.empty()) {
    const spirv::Id id = waiting.back();
    waiting.pop_back();
    const spirv::Instruction* definition = seen.insert(id).second ? code_.definition(id) : nullptr;
    if (definition == nullptr) continue;
    if (comes_from_outside(*definition)) return false;
    for (const spirv::Id operand : code_.ids(*definition)) waiting.push_back(operand);
    for (const auto* sources : {&stored_, &given_})
      if (const auto found = sources->find(id); found != sources->end())
        waiting.insert(waiting.end(), found->second.begin(), found->second.end());
  }
  return true;
}

}  // namespace penumbra::lint
