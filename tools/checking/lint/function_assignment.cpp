#include "lint/function_assignment.h"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "lint/components.h"
#include "lint/first_iteration.h"

namespace penumbra::lint {

namespace {

// Functions with more components times blocks are not checked.
constexpr std::size_t most_work = 64'000'000;

// A value with unassigned components, and the variable from which it was read.
struct PartlySet {
  Components set;
  std::size_t variable = no_node;  // the local variable it was loaded from, or
  Part part;                       // part of that local variable, or of what the function returned
  spirv::Id callee = 0;            // the function that returned it
};

bool is_aggregate(const spirv::Code& code, spirv::Id type) {
  const spv::Op op = code.op(type);
  return op == spv::OpTypeStruct || op == spv::OpTypeArray;
}

class FunctionAssignment {
 public:
  FunctionAssignment(const spirv::Code& code, const spirv::Function& function,
                     const std::vector<bool>& is_out, const std::map<spirv::Id, FunctionEffect>& effects)
      : code_(code),
        function_(function),
        layout_(code),
        memory_(code, function, layout_),
        paths_(paths_of(code, function)),
        is_out_(is_out),
        effects_(effects) {
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
      effect_.parameters.push_back({is_out[i], {}, {}});
    for (const LocalVariable& variable : memory_.variables())
      if (variable.parameter >= 0) {
        ParameterEffect& parameter = effect_.parameters[static_cast<std::size_t>(variable.parameter)];
        parameter.read.assign(variable.count, false);
        parameter.set.assign(variable.count, true);
      }
  }

  void run() {
    if (memory_.components() * paths_.block.size() > most_work) {
      findings.too_large = true;
      for (ParameterEffect& parameter : effect_.parameters)
        parameter.read.assign(parameter.read.size(), false);
      return;
    }
    settle();
    reporting_ = true;
    for (const std::size_t node : paths_.order) {
      state_ = at_start_of(node);
      walk(node);
    }
    report_outputs();
  }

  FunctionEffect take_effect() { return std::move(effect_); }
  AssignmentFindings findings;

 private:
  // Computes the greatest fixed point: it starts from "everything is set" and removes components until
  // nothing changes.
  void settle() {
    at_end_.assign(paths_.block.size(), Components(memory_.components(), true));
    for (bool changed = true; changed;) {
      changed = false;
      values_changed_ = false;
      for (const std::size_t node : paths_.order) {
        state_ = at_start_of(node);
        walk(node);
        if (state_ == at_end_[node]) continue;
        at_end_[node] = state_;
        changed = true;
      }
      changed = changed || values_changed_;
    }
  }

  Components at_start_of(std::size_t node) const {
    Components state(memory_.components(), true);
    for (const std::size_t from : paths_.predecessors[node])
      if (reachable(from)) intersect(state, at_end_[from]);
    if (node == 0) {
      for (const LocalVariable& variable : memory_.variables())
        std::fill_n(state.begin() + static_cast<std::ptrdiff_t>(variable.first), variable.count,
                    variable.initialised);
    }
    return state;
  }

  bool reachable(std::size_t node) const {
    if (reachable_.empty()) {
      reachable_.assign(paths_.block.size(), false);
      for (const std::size_t known : paths_.order) reachable_[known] = true;
    }
    return reachable_[node];
  }

  void walk(std::size_t node) {
    const spirv::Block& block = function_.blocks[paths_.block[node]];
    for (std::size_t i = block.begin; i < block.end; ++i) step(code_.instructions()[i]);
  }

  void step(const spirv::Instruction& instruction) {
    switch (instruction.op) {
      case spv::OpLoad:
        return load(instruction);
      case spv::OpStore:
        return store(instruction);
      case spv::OpCompositeExtract:
        return extract(instruction);
      case spv::OpCompositeConstruct:
        return construct(instruction);
      case spv::OpCopyLogical:
      case spv::OpCopyObject:
        if (const PartlySet* value = partly_set(instruction.operands[0]))
          remember(instruction.result, *value);
        return;
      case spv::OpFunctionCall:
        return call(instruction);
      case spv::OpReturnValue:
        return return_value(instruction);
      case spv::OpReturn:
        return end(instruction);
      default:
        return;
    }
  }

  Components part_of(const Components& state, std::size_t variable, const Part& part) const {
    const auto first =
        state.begin() + static_cast<std::ptrdiff_t>(memory_.variables()[variable].first + part.first);
    Components set(first, first + static_cast<std::ptrdiff_t>(part.count));
    if (part.exact) return set;
    return Components(part.count, !none(set));
  }

  bool is_given(std::size_t variable) const {
    const int parameter = memory_.variables()[variable].parameter;
    return parameter >= 0 && !is_out_[static_cast<std::size_t>(parameter)];
  }

  // A value that is only copied for the call that follows is not read yet: the callee's effect has its reads.
  bool only_for_calls(spirv::Id value) const {
    const auto& users = memory_.uses(value);
    return !users.empty() && std::all_of(users.begin(), users.end(), [&](const spirv::Instruction* user) {
      const LocalPointer* target = user->op == spv::OpStore ? memory_.pointer(user->operands[0]) : nullptr;
      return target != nullptr && memory_.variables()[target->variable].copy_for_call;
    });
  }

  void load(const spirv::Instruction& instruction) {
    const LocalPointer* from = memory_.pointer(instruction.operands[0]);
    if (from == nullptr) return;
    const LocalVariable& variable = memory_.variables()[from->variable];
    const Components set = part_of(state_, from->variable, from->part);
    if (all(set)) return;
    const bool copied = is_aggregate(code_, instruction.type) || variable.copy_for_call;
    const bool for_calls = only_for_calls(instruction.result);
    if (copied || for_calls) {
      // Values from the caller count as assigned once they are copied to another variable: reading the copy
      // would have to be reported in the caller, which is not possible.
      if (for_calls || !is_given(from->variable))
        remember(instruction.result, {set, from->variable, from->part, 0});
      return;
    }
    read(from->variable, from->part, set, wanted(instruction, set.size()), instruction.place, 0);
  }

  // Returns the components of a loaded vector that anything uses.
  Components wanted(const spirv::Instruction& loaded, std::size_t count) const {
    if (code_.op(loaded.type) != spv::OpTypeVector) return Components(count, true);
    Components used(count, false);
    const auto use = [&](std::uint32_t component) {
      if (component < count) used[component] = true;
    };
    for (const spirv::Instruction* user : memory_.uses(loaded.result)) {
      if (user->op == spv::OpCompositeExtract) {
        use(user->operands[1]);
      } else if (user->op == spv::OpVectorShuffle) {
        shuffle_uses(*user, loaded.result, count, use);
      } else {
        return Components(count, true);
      }
    }
    return used;
  }

  template <typename Use>
  void shuffle_uses(const spirv::Instruction& shuffle, spirv::Id value, std::size_t count,
                    const Use& use) const {
    const spirv::Instruction* first = code_.definition(shuffle.operands[0]);
    const spirv::Instruction* type = first == nullptr ? nullptr : code_.definition(first->type);
    const std::uint32_t first_count = type == nullptr ? static_cast<std::uint32_t>(count) : type->operands[1];
    for (std::size_t i = 2; i < shuffle.operands.size(); ++i) {
      const std::uint32_t component = shuffle.operands[i];
      if (shuffle.operands[0] == value && component < first_count) use(component);
      if (shuffle.operands[1] == value && component >= first_count) use(component - first_count);
    }
  }

  // Components of a part are used; `set` says which of them have a value here.
  void read(std::size_t variable, const Part& part, const Components& set, const Components& used,
            spirv::Place place, spirv::Id callee) {
    const LocalVariable& of = memory_.variables()[variable];
    Components known(of.count, true);
    for (std::size_t i = 0; i < part.count && i < set.size(); ++i)
      if (!set[i] && i < used.size() && used[i]) known[part.first + i] = false;
    if (all(known)) return;
    if (of.copy_for_call) return;  // its source is reported, or the variable that it is copied back to
    if (is_given(variable)) {
      Components& needed = effect_.parameters[static_cast<std::size_t>(of.parameter)].read;
      for (std::size_t i = 0; i < known.size(); ++i) needed[i] = needed[i] || !known[i];
    } else if (reporting_ && reported_.insert({of.id, place.file, place.line}).second) {
      findings.reads.push_back({of.id, callee, of.type, known, is_ever_set(of, known), place});
    }
  }

  static bool is_ever_set(const LocalVariable& variable, const Components& known) {
    for (std::size_t i = 0; i < known.size(); ++i)
      if (!known[i] && variable.stored[i]) return true;
    return false;
  }

  void store(const spirv::Instruction& instruction) {
    const PartlySet* value = partly_set(instruction.operands[1]);
    const LocalPointer* to = memory_.pointer(instruction.operands[0]);
    if (to == nullptr) {
      if (value != nullptr) used_whole(*value, instruction.place);
      return;
    }
    set_part(to->variable, to->part, value);
  }

  void set_part(std::size_t variable, const Part& part, const PartlySet* value) {
    const bool copy = value != nullptr && part.exact && value->set.size() == part.count;
    const std::size_t first = memory_.variables()[variable].first + part.first;
    for (std::size_t i = 0; i < part.count; ++i) state_[first + i] = !copy || value->set[i];
  }

  void used_whole(const PartlySet& value, spirv::Place place) {
    use_of(value, Components(value.set.size(), true), place);
  }

  void use_of(const PartlySet& value, const Components& used, spirv::Place place) {
    if (value.variable != no_node) return read(value.variable, value.part, value.set, used, place, 0);
    const spirv::Id type = code_.function(value.callee)->result_type;
    Components known(layout_.count(type), true);
    for (std::size_t i = 0; i < value.set.size(); ++i) known[value.part.first + i] = value.set[i] || !used[i];
    if (!all(known) && reporting_ && reported_.insert({value.callee, place.file, place.line}).second)
      findings.reads.push_back({0, value.callee, type, known, true, place});
  }

  void extract(const spirv::Instruction& instruction) {
    const PartlySet* whole = partly_set(instruction.operands[0]);
    if (whole == nullptr) return;
    Part part{0, whole->set.size(), code_.definition(instruction.operands[0])->type, true};
    for (std::size_t i = 1; i < instruction.operands.size(); ++i)
      part = layout_.select_literal(part, instruction.operands[i]);
    if (!part.exact) return;
    const auto first = whole->set.begin() + static_cast<std::ptrdiff_t>(part.first);
    PartlySet inner = *whole;
    if (is_aggregate(code_, instruction.type)) {
      inner.set.assign(first, first + static_cast<std::ptrdiff_t>(part.count));
      inner.part.first += part.first;
      inner.part.count = part.count;
      return remember(instruction.result, inner);
    }
    Components used(whole->set.size(), false);
    std::fill_n(used.begin() + static_cast<std::ptrdiff_t>(part.first), part.count, true);
    use_of(*whole, used, instruction.place);
  }

  void construct(const spirv::Instruction& instruction) {
    for (const spirv::Id constituent : instruction.operands)
      if (const PartlySet* value = partly_set(constituent)) used_whole(*value, instruction.place);
  }

  void call(const spirv::Instruction& instruction) {
    const auto found = effects_.find(instruction.operands[0]);
    if (found == effects_.end()) return;
    const FunctionEffect& effect = found->second;
    for (std::size_t i = 0; i + 1 < instruction.operands.size() && i < effect.parameters.size(); ++i)
      if (const LocalPointer* argument = memory_.pointer(instruction.operands[i + 1]))
        pass(instruction, *argument, effect.parameters[i]);
    if (!effect.result.empty() && !all(effect.result)) {
      const Part whole{0, effect.result.size(), instruction.type, true};
      remember(instruction.result, {effect.result, no_node, whole, instruction.operands[0]});
    }
  }

  void pass(const spirv::Instruction& call, const LocalPointer& argument, const ParameterEffect& effect) {
    if (effect.is_out) return set_part(argument.variable, argument.part, nullptr);
    const LocalPointer given = source_of(argument);
    const Components set = part_of(state_, argument.variable, argument.part);
    Components here = part_of(state_, given.variable, given.part);
    if (given.variable == argument.variable || here.size() != set.size()) here = set;
    if (effect.read.size() == here.size() && !all(here))
      read(given.variable, given.part, here, effect.read, call.place, call.operands[0]);
    if (!argument.part.exact || effect.set.size() != argument.part.count) return;
    const std::size_t first = memory_.variables()[argument.variable].first + argument.part.first;
    for (std::size_t i = 0; i < effect.set.size(); ++i)
      state_[first + i] = state_[first + i] || effect.set[i];
  }

  // Returns the variable whose value glslang's argument copy has; the argument itself if it is not such a
  // copy.
  LocalPointer source_of(const LocalPointer& argument) const {
    const LocalVariable& copy = memory_.variables()[argument.variable];
    if (!copy.copy_for_call) return argument;
    for (const spirv::Instruction* user : memory_.uses(copy.id)) {
      if (user->op != spv::OpStore || user->operands[0] != copy.id) continue;
      const spirv::Instruction* value = code_.definition(user->operands[1]);
      if (value == nullptr || value->op != spv::OpLoad) continue;
      if (const LocalPointer* from = memory_.pointer(value->operands[0])) return *from;
    }
    return argument;
  }

  void return_value(const spirv::Instruction& instruction) {
    if (code_.op(instruction.operands[0]) == spv::OpUndef) {
      nothing_returned_ = true;
    } else if (const PartlySet* value = partly_set(instruction.operands[0])) {
      if (effect_.result.empty()) effect_.result.assign(value->set.size(), true);
      intersect(effect_.result, value->set);
      if (reporting_ && !result_place_) result_place_ = instruction.place;
    }
    end(instruction);
  }

  void end(const spirv::Instruction&) {
    for (std::size_t i = 0; i < memory_.variables().size(); ++i) {
      const LocalVariable& variable = memory_.variables()[i];
      if (variable.parameter < 0) continue;
      const Part whole{0, variable.count, variable.type, true};
      intersect(effect_.parameters[static_cast<std::size_t>(variable.parameter)].set,
                part_of(state_, i, whole));
    }
  }

  void report_outputs() {
    if (nothing_returned_)
      findings.outputs.push_back({0, function_.result_type, {}, true, false, function_.place});
    if (!effect_.result.empty() && !all(effect_.result))
      findings.outputs.push_back(
          {0, function_.result_type, effect_.result, false, true, result_place_.value_or(function_.place)});
    for (const LocalVariable& variable : memory_.variables()) {
      if (variable.parameter < 0) continue;
      const ParameterEffect& effect = effect_.parameters[static_cast<std::size_t>(variable.parameter)];
      if (effect.is_out && !all(effect.set))
        findings.outputs.push_back(
            {variable.id, variable.type, effect.set, false, all(variable.stored), function_.place});
    }
  }

  const PartlySet* partly_set(spirv::Id value) const {
    const auto found = values_.find(value);
    return found == values_.end() || all(found->second.set) ? nullptr : &found->second;
  }

  // Two nodes may refer to one instruction: a component that either leaves unassigned is unassigned.
  void remember(spirv::Id value, const PartlySet& what) {
    const auto [known, is_new] = values_.emplace(value, what);
    const Components before = known->second.set;
    if (!is_new) intersect(known->second.set, what.set);
    values_changed_ = values_changed_ || is_new || known->second.set != before;
  }

  const spirv::Code& code_;
  const spirv::Function& function_;
  ComponentLayout layout_;
  LocalMemory memory_;
  Paths paths_;
  const std::vector<bool>& is_out_;
  const std::map<spirv::Id, FunctionEffect>& effects_;

  FunctionEffect effect_;
  Components state_;
  std::vector<Components> at_end_;
  mutable std::vector<bool> reachable_;
  std::map<spirv::Id, PartlySet> values_;
  bool values_changed_ = false;
  bool reporting_ = false;
  bool nothing_returned_ = false;
  std::optional<spirv::Place> result_place_;
  std::set<std::tuple<spirv::Id, spirv::Id, int>> reported_;
};

}  // namespace

FunctionResult function_assignment(const spirv::Code& code, const spirv::Function& function,
                                   const std::vector<bool>& is_out,
                                   const std::map<spirv::Id, FunctionEffect>& effects) {
  FunctionAssignment assignment(code, function, is_out, effects);
  assignment.run();
  return {std::move(assignment.findings), assignment.take_effect()};
}

}  // namespace penumbra::lint
