#include "lint/local_memory.h"

#include <algorithm>

namespace penumbra::lint {

LocalMemory::LocalMemory(const spirv::Code& code, const spirv::Function& function, ComponentLayout& layout)
    : code_(code), layout_(layout) {
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const spirv::Id parameter = function.parameters[i];
    add(parameter, code.definition(parameter)->type, static_cast<int>(i), false);
  }
  for (const spirv::Block& block : function.blocks)
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const spirv::Instruction& instruction = code.instructions()[i];
      for (const spirv::Id operand : code.ids(instruction)) {
        std::vector<const spirv::Instruction*>& users = uses_[operand];
        if (users.empty() || users.back() != &instruction) users.push_back(&instruction);
      }
      if (instruction.op == spv::OpVariable) {
        add(instruction.result, instruction.type, -1, instruction.operands.size() > 1);
      } else if (instruction.op == spv::OpAccessChain || instruction.op == spv::OpInBoundsAccessChain) {
        follow(instruction, layout);
      } else if (instruction.op == spv::OpStore) {
        note_store(instruction.operands[0]);
      }
    }
}

void LocalMemory::add(spirv::Id id, spirv::Id pointer_type, int parameter, bool initialised) {
  if (code_.storage_class(pointer_type) != spv::StorageClassFunction) return;
  const spirv::Id type = code_.pointee(pointer_type);
  const std::size_t count = layout_.count(type);
  pointers_[id] = {variables_.size(), {0, count, type, true}};
  variables_.push_back({id, type, components_, count, parameter, initialised, code_.name(id) == "param",
                        Components(count, false)});
  components_ += count;
}

void LocalMemory::follow(const spirv::Instruction& chain, ComponentLayout& layout) {
  const LocalPointer* base = pointer(chain.operands[0]);
  if (base == nullptr) return;
  LocalPointer inner = *base;
  for (std::size_t i = 1; i < chain.operands.size(); ++i)
    inner.part = layout.select(inner.part, chain.operands[i]);
  inner.part.type = code_.pointee(chain.type);
  pointers_[chain.result] = inner;
}

void LocalMemory::note_store(spirv::Id target) {
  const LocalPointer* to = pointer(target);
  if (to == nullptr) return;
  Components& stored = variables_[to->variable].stored;
  std::fill_n(stored.begin() + static_cast<std::ptrdiff_t>(to->part.first), to->part.count, true);
}

const LocalPointer* LocalMemory::pointer(spirv::Id id) const {
  const auto found = pointers_.find(id);
  return found == pointers_.end() ? nullptr : &found->second;
}

const std::vector<const spirv::Instruction*>& LocalMemory::uses(spirv::Id value) const {
  static const std::vector<const spirv::Instruction*> none;
  const auto found = uses_.find(value);
  return found == uses_.end() ? none : found->second;
}

}  // namespace penumbra::lint
