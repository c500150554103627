#include "shaders/written_arguments.h"

#include <glslang/MachineIndependent/localintermediate.h>

#include <algorithm>
#include <utility>

namespace penumbra::shaders {
namespace {

bool is_written(glslang::TStorageQualifier qualifier) {
  return qualifier == glslang::EvqOut || qualifier == glslang::EvqInOut;
}

bool is_arithmetic(glslang::TOperator op) {
  switch (op) {
    case glslang::EOpAdd:
    case glslang::EOpSub:
    case glslang::EOpMul:
    case glslang::EOpDiv:
    case glslang::EOpMod:
    case glslang::EOpVectorTimesScalar:
    case glslang::EOpNegative:
    case glslang::EOpLogicalNot:
    case glslang::EOpBitwiseNot:
      return true;
    default:
      return false;
  }
}

bool is_value(glslang::TIntermTyped& argument) {
  if (argument.getAsConstantUnion() != nullptr) return true;
  const glslang::TIntermOperator* made = argument.getAsOperator();
  return made != nullptr && is_arithmetic(made->getOp());
}

// HLSL converts an inout argument of another type in both directions, glslang only on input.
bool is_converted(glslang::TIntermTyped& argument) {
  const glslang::TIntermUnary* made = argument.getAsUnaryNode();
  return made != nullptr && made->getOperand()->getBasicType() != argument.getBasicType();
}

class Search final : public glslang::TIntermTraverser {
 public:
  bool visitAggregate(glslang::TVisit /*when*/, glslang::TIntermAggregate* node) override {
    if (node->getOp() != glslang::EOpFunctionCall) return true;
    const glslang::TIntermSequence& arguments = node->getSequence();
    const glslang::TQualifierList& qualifiers = node->getQualifierList();
    for (std::size_t i = 0; i < std::min(arguments.size(), qualifiers.size()); ++i) {
      glslang::TIntermTyped* argument = arguments[i]->getAsTyped();
      if (argument == nullptr || !is_written(qualifiers[i])) continue;
      if (is_value(*argument)) tell(*node, i, "which is not an lvalue: pass a variable");
      if (is_converted(*argument))
        tell(*node, i, "which has another type: pass a variable of the parameter's type");
    }
    return true;
  }

  void tell(const glslang::TIntermAggregate& call, std::size_t argument, const std::string& what) {
    const std::string name(call.getName().c_str());
    found.push_back(error_at(call, "'" + name.substr(0, name.find('(')) + "' writes to its argument " +
                                       std::to_string(argument + 1) + ", " + what));
  }

  std::vector<hlsl::Diagnostic> found;
};

}  // namespace

std::vector<hlsl::Diagnostic> unwritable_arguments(const glslang::TIntermediate& tree) {
  Search search;
  if (tree.getTreeRoot() != nullptr) tree.getTreeRoot()->traverse(&search);
  return std::move(search.found);
}

}  // namespace penumbra::shaders
