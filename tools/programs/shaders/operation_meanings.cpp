#include "shaders/operation_meanings.h"

#include <glslang/MachineIndependent/localintermediate.h>

#include "shaders/tree_rewrite.h"

namespace penumbra::shaders {
namespace {

using glslang::TIntermTyped;

class OperationMeanings final : public TreeRewrite {
 private:
  TIntermTyped* of_unary(glslang::TIntermUnary& node) override {
    TIntermTyped* operand = node.getOperand();
    const bool is_number = !operand->isMatrix() && !operand->isArray();
    if (operand->getBasicType() != glslang::EbtUint || !is_number) return &node;
    if (node.getOp() == glslang::EOpAbs) return operand;
    if (node.getOp() != glslang::EOpNegative) return &node;
    return binary_node(node, glslang::EOpSub, zero(operand->getVectorSize()), operand, node.getType());
  }

  static TIntermTyped* zero(int size) {
    glslang::TConstUnionArray values(size);
    for (int i = 0; i < size; ++i) values[i].setUConst(0);
    return new glslang::TIntermConstantUnion(values,
                                             glslang::TType(glslang::EbtUint, glslang::EvqConst, size));
  }

  // The sample number is a uint in HLSL, and an int in GLSL, where it is not converted implicitly.
  static TIntermTyped* with_int_sample(glslang::TIntermAggregate& node) {
    TIntermTyped* sample = node.getSequence()[1]->getAsTyped();
    if (sample->getBasicType() == glslang::EbtUint)
      node.getSequence()[1] = unary_node(node, glslang::EOpConvUintToInt, sample,
                                         glslang::TType(glslang::EbtInt, glslang::EvqTemporary));
    return &node;
  }

  TIntermTyped* of_aggregate(glslang::TIntermAggregate& node) override {
    const glslang::TIntermSequence& given = node.getSequence();
    const glslang::TType& type = node.getType();
    const auto argument = [&](std::size_t i) { return given[i]->getAsTyped(); };
    if (node.getOp() == glslang::EOpFma && given.size() == 3) {
      TIntermTyped* product = binary_node(node, glslang::EOpMul, argument(0), argument(1), type);
      return binary_node(node, glslang::EOpAdd, product, argument(2), type);
    }
    if (node.getOp() == glslang::EOpInterpolateAtSample && given.size() == 2) return with_int_sample(node);
    if (node.getOp() == glslang::EOpLdexp && given.size() == 2) {
      TIntermTyped* scale = unary_node(node, glslang::EOpExp2, argument(1), argument(1)->getType());
      return binary_node(node, glslang::EOpMul, argument(0), scale, type);
    }
    return &node;
  }
};

}  // namespace

void correct_operations(glslang::TIntermediate& tree) {
  OperationMeanings().run(tree);
}

}  // namespace penumbra::shaders
