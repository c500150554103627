#include "shaders/tree_rewrite.h"

#include <glslang/MachineIndependent/localintermediate.h>

namespace penumbra::shaders {

using glslang::TIntermAggregate;
using glslang::TIntermBinary;
using glslang::TIntermTyped;
using glslang::TIntermUnary;

void TreeRewrite::run(glslang::TIntermediate& tree) {
  if (tree.getTreeRoot() != nullptr) tree.setTreeRoot(rewritten(tree.getTreeRoot()));
}

TIntermTyped* TreeRewrite::of_aggregate(TIntermAggregate& node) {
  return &node;
}

TIntermTyped* TreeRewrite::of_binary(TIntermBinary& node) {
  return &node;
}

TIntermTyped* TreeRewrite::of_unary(TIntermUnary& node) {
  return &node;
}

TIntermNode* TreeRewrite::rewritten(TIntermNode* node) {
  if (node == nullptr) return nullptr;
  if (TIntermAggregate* aggregate = node->getAsAggregate()) {
    for (TIntermNode*& child : aggregate->getSequence()) child = rewritten(child);
    return of_aggregate(*aggregate);
  }
  if (TIntermBinary* binary = node->getAsBinaryNode()) {
    binary->setLeft(typed(binary->getLeft()));
    binary->setRight(typed(binary->getRight()));
    return of_binary(*binary);
  }
  if (TIntermUnary* unary = node->getAsUnaryNode()) {
    unary->setOperand(typed(unary->getOperand()));
    return of_unary(*unary);
  }
  if (glslang::TIntermSelection* selection = node->getAsSelectionNode()) return of_selection(*selection);
  if (glslang::TIntermLoop* loop = node->getAsLoopNode()) return of_loop(*loop);
  if (glslang::TIntermSwitch* choice = node->getAsSwitchNode()) return of_switch(*choice);
  if (glslang::TIntermBranch* branch = node->getAsBranchNode())
    branch->setExpression(typed(branch->getExpression()));
  return node;
}

TIntermTyped* TreeRewrite::typed(TIntermTyped* node) {
  TIntermNode* result = rewritten(node);
  return result == nullptr ? nullptr : result->getAsTyped();
}

// glslang's setters expect typed values as blocks, which those of an if statement are not.
TIntermNode* TreeRewrite::of_selection(glslang::TIntermSelection& node) {
  node.setCondition(typed(node.getCondition()));
  TIntermNode* yes = rewritten(node.getTrueBlock());
  TIntermNode* no = rewritten(node.getFalseBlock());
  if (yes == node.getTrueBlock() && no == node.getFalseBlock()) return &node;
  auto* made = node.getBasicType() == glslang::EbtVoid
                   ? new glslang::TIntermSelection(node.getCondition(), yes, no)
                   : new glslang::TIntermSelection(node.getCondition(), yes, no, node.getType());
  if (!node.getShortCircuit()) made->setNoShortCircuit();
  if (node.getFlatten()) made->setFlatten();
  if (node.getDontFlatten()) made->setDontFlatten();
  made->setLoc(node.getLoc());
  return made;
}

TIntermNode* TreeRewrite::of_loop(glslang::TIntermLoop& node) {
  TIntermNode* body = rewritten(node.getBody());
  TIntermTyped* test = typed(node.getTest());
  TIntermTyped* terminal = typed(node.getTerminal());
  if (body == node.getBody() && test == node.getTest() && terminal == node.getTerminal()) return &node;
  auto* made = new glslang::TIntermLoop(body, test, terminal, node.testFirst());
  if (node.getUnroll()) made->setUnroll();
  if (node.getDontUnroll()) made->setDontUnroll();
  made->setLoopDependency(node.getLoopDependency());
  made->setLoc(node.getLoc());
  return made;
}

TIntermNode* TreeRewrite::of_switch(glslang::TIntermSwitch& node) {
  TIntermNode* condition = rewritten(node.getCondition());
  if (node.getBody() != nullptr)
    for (TIntermNode*& child : node.getBody()->getSequence()) child = rewritten(child);
  if (condition == node.getCondition()) return &node;
  auto* made = new glslang::TIntermSwitch(condition->getAsTyped(), node.getBody());
  if (node.getFlatten()) made->setFlatten();
  if (node.getDontFlatten()) made->setDontFlatten();
  made->setLoc(node.getLoc());
  return made;
}

hlsl::Diagnostic error_at(const TIntermNode& node, std::string message) {
  const glslang::TSourceLoc& at = node.getLoc();
  return error_at(SourcePlace{at.getFilename() == nullptr ? "" : at.getFilename(), at.line},
                  std::move(message));
}

TIntermTyped* unary_node(const TIntermNode& at, glslang::TOperator op, TIntermTyped* operand,
                         const glslang::TType& type) {
  auto* made = new TIntermUnary(op);
  made->setOperand(operand);
  made->setType(type);
  made->setLoc(at.getLoc());
  return made;
}

TIntermTyped* binary_node(const TIntermNode& at, glslang::TOperator op, TIntermTyped* left,
                          TIntermTyped* right, const glslang::TType& type) {
  auto* made = new TIntermBinary(op);
  made->setLeft(left);
  made->setRight(right);
  made->setType(type);
  made->setLoc(at.getLoc());
  return made;
}

}  // namespace penumbra::shaders
