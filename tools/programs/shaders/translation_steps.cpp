#include "shaders/translation_steps.h"
#include "spirv/code.h"

#include <algorithm>

namespace penumbra::shaders {

namespace {

using spirv::Id;
using spirv::Instruction;

class StepFinder {
 public:
  explicit StepFinder(const spirv::Code& code) : code_(code) {}

  // The search runs from the last instruction, so that all uses of a result are known before it.
  std::set<Id> run() {
    const std::vector<Instruction>& all = code_.instructions();
    for (auto one = all.rbegin(); one != all.rend(); ++one) {
      const bool is = is_step(*one);
      if (is) steps_.insert(one->result);
      use_operands(*one, is);
    }
    return std::move(steps_);
  }

 private:
  bool is_step(const Instruction& one) const {
    switch (one.op) {
      case spv::OpSelect:
        return makes_mask(one);
      case spv::OpINotEqual:  // it is the program's own if no mask is made of it
        return is_constant(one.operands[1], 0) && !masked_.contains(one.result);
      case spv::OpIAdd:
      case spv::OpIMul:
      case spv::OpShiftRightLogical:
      case spv::OpBitwiseAnd:
        return addresses_.contains(one.result) && !kept_.contains(one.result);
      default:
        return false;
    }
  }

  void use_operands(const Instruction& one, bool is_a_step) {
    if (one.op == spv::OpSelect && makes_mask(one)) masked_.insert(one.operands[0]);
    const bool chain = one.op == spv::OpAccessChain || one.op == spv::OpInBoundsAccessChain;
    const bool shift = one.op >= spv::OpShiftRightLogical && one.op <= spv::OpShiftLeftLogical;
    for (std::size_t i = 0; i < code_.ids(one).size(); ++i) {
      const Id id = code_.ids(one)[i];
      const bool of_address = is_a_step || (chain && i > 0) || (shift && i == 1);
      (of_address ? addresses_ : kept_).insert(id);
    }
  }

  bool makes_mask(const Instruction& select) const {
    return is_constant(select.operands[1], 0xFFFFFFFFU) && is_constant(select.operands[2], 0);
  }

  // Every component of a vector must have the value.
  bool is_constant(Id id, std::uint32_t value) const {
    const Instruction* definition = code_.definition(id);
    if (definition == nullptr) return false;
    if (definition->op == spv::OpConstant) return definition->operands[0] == value;
    return definition->op == spv::OpConstantComposite &&
           std::all_of(definition->operands.begin(), definition->operands.end(),
                       [&](Id component) { return is_constant(component, value); });
  }

  const spirv::Code& code_;
  std::set<Id> steps_;
  std::set<Id> masked_;            // conditions that become masks
  std::set<Id> addresses_, kept_;  // used in an address or a shift's number, and otherwise
};

}  // namespace

std::set<Id> translation_steps(const spirv::Module& untouched) {
  const spirv::Code code(untouched);
  return StepFinder(code).run();
}

}  // namespace penumbra::shaders
