// A traversal of glslang's syntax tree that replaces nodes. Internal to this folder.
#pragma once

#include <glslang/Include/intermediate.h>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Children are visited before their parents. Nodes that an override creates must be allocated in the memory
// pool of the current thread's program, as glslang's nodes are by default.
class TreeRewrite {
 public:
  virtual ~TreeRewrite() = default;
  void run(glslang::TIntermediate& tree);

 protected:
  // Each returns the node's replacement: the node itself if nothing changes.
  virtual glslang::TIntermTyped* of_aggregate(glslang::TIntermAggregate& node);
  virtual glslang::TIntermTyped* of_binary(glslang::TIntermBinary& node);
  virtual glslang::TIntermTyped* of_unary(glslang::TIntermUnary& node);

 private:
  TIntermNode* rewritten(TIntermNode* node);
  glslang::TIntermTyped* typed(glslang::TIntermTyped* node);
  TIntermNode* of_selection(glslang::TIntermSelection& node);
  TIntermNode* of_loop(glslang::TIntermLoop& node);
  TIntermNode* of_switch(glslang::TIntermSwitch& node);
};

hlsl::Diagnostic error_at(const TIntermNode& node, std::string message);

// Creates nodes at another node's source location.
glslang::TIntermTyped* unary_node(const TIntermNode& at, glslang::TOperator op,
                                  glslang::TIntermTyped* operand, const glslang::TType& type);
glslang::TIntermTyped* binary_node(const TIntermNode& at, glslang::TOperator op, glslang::TIntermTyped* left,
                                   glslang::TIntermTyped* right, const glslang::TType& type);

}  // namespace penumbra::shaders
