#include "lint/components.h"

#include <algorithm>

namespace penumbra::lint {

bool all(const Components& set) {
  return std::find(set.begin(), set.end(), false) == set.end();
}

bool none(const Components& set) {
  return std::find(set.begin(), set.end(), true) == set.end();
}

void intersect(Components& into, const Components& other) {
  for (std::size_t i = 0; i < into.size() && i < other.size(); ++i) into[i] = into[i] && other[i];
}

ComponentLayout::Parts ComponentLayout::parts(spirv::Id type) const {
  const spirv::Instruction* definition = code_.definition(type);
  if (definition == nullptr) return {};
  switch (definition->op) {
    case spv::OpTypeVector:
    case spv::OpTypeMatrix:
      return {definition->operands[1], definition->operands[0]};
    case spv::OpTypeArray:
      return {static_cast<std::size_t>(
                  std::max<std::int64_t>(0, code_.integer(definition->operands[1]).value_or(0))),
              definition->operands[0]};
    case spv::OpTypeStruct:
      return {definition->operands.size(), 0};
    default:
      return {};
  }
}

// Types are defined before they are used, so the recursion is as deep as the nesting in the source.
std::size_t ComponentLayout::uncapped(spirv::Id type) {
  const auto known = counts_.find(type);
  if (known != counts_.end()) return known->second;
  const Parts of = parts(type);
  std::size_t sum = 0;
  if (of.number == 0) {
    sum = 1;
  } else if (of.type != 0) {
    sum = of.number * std::min(uncapped(of.type), most_components + 1);
  } else {
    const spirv::Instruction& structure = *code_.definition(type);
    for (const spirv::Id member : structure.operands) sum += std::min(uncapped(member), most_components + 1);
  }
  counts_[type] = std::min(sum, most_components + 1);
  return counts_[type];
}

std::size_t ComponentLayout::count(spirv::Id type) {
  const std::size_t components = uncapped(type);
  return components > most_components ? 1 : components;
}

Part ComponentLayout::select_literal(const Part& whole, std::uint32_t index) {
  const Parts of = parts(whole.type);
  if (of.number == 0) return {whole.first, whole.count, 0, false};
  const spirv::Id type =
      of.type != 0 || index >= of.number ? of.type : code_.definition(whole.type)->operands[index];
  const bool one_for_all = uncapped(whole.type) > most_components;
  if (one_for_all || index >= of.number || !whole.exact) return {whole.first, whole.count, type, false};
  std::size_t first = whole.first;
  if (of.type != 0) {
    first += index * uncapped(of.type);
  } else {
    for (std::uint32_t i = 0; i < index; ++i) first += uncapped(code_.definition(whole.type)->operands[i]);
  }
  return {first, uncapped(type), type, true};
}

Part ComponentLayout::select(const Part& whole, spirv::Id index_constant) {
  const std::optional<std::int64_t> index = code_.integer(index_constant);
  if (index && *index >= 0) return select_literal(whole, static_cast<std::uint32_t>(*index));
  return {whole.first, whole.count, parts(whole.type).type, false};
}

std::string ComponentLayout::step(spirv::Id type, std::size_t index) const {
  const spv::Op op = code_.op(type);
  if (op == spv::OpTypeStruct) return "." + code_.member_name(type, static_cast<std::uint32_t>(index));
  if (op == spv::OpTypeVector) return std::string(".") + (index < 4 ? "xyzw"[index] : '?');
  return "[" + std::to_string(index) + "]";
}

ComponentLayout::Missing ComponentLayout::first_missing(spirv::Id type, const Components& set) {
  const auto holds = [&](const Part& part, bool what) {
    const auto begin = set.begin() + static_cast<std::ptrdiff_t>(part.first);
    const auto end = begin + static_cast<std::ptrdiff_t>(part.count);
    return std::find(begin, end, what) != end;
  };
  Missing missing{"", 0, set.size()};
  Part part{0, set.size(), type, true};
  for (bool deeper = true; deeper && holds(part, true);) {
    deeper = false;
    const std::size_t number = uncapped(part.type) > most_components ? 0 : parts(part.type).number;
    for (std::uint32_t i = 0; i < number && !deeper; ++i) {
      const Part inner = select_literal(part, i);
      if (!holds(inner, false)) continue;
      missing = {missing.path + step(part.type, i), inner.first, inner.count};
      part = inner;
      deeper = true;
    }
  }
  return missing;
}

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
