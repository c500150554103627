// A walk over glslang's tree that puts other nodes in the place of some. Internal to this room.
#pragma once

#include <glslang/Include/intermediate.h>

#include "shaders/spirv_module.h"

namespace penumbra::shaders {

// Children come before their parents. What an override makes must stand in the memory of the current thread's
// program, as glslang's nodes do by themselves.
class TreeRewrite {
 public:
  virtual ~TreeRewrite() = default;
  void run(glslang::TIntermediate& tree);

 protected:
  // What stands in the node's place: itself where nothing changes.
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

SourcePlace place_of_node(const TIntermNode& node);

// Nodes at the place of another.
glslang::TIntermTyped* unary_node(const TIntermNode& at, glslang::TOperator op,
                                  glslang::TIntermTyped* operand, const glslang::TType& type);
glslang::TIntermTyped* binary_node(const TIntermNode& at, glslang::TOperator op, glslang::TIntermTyped* left,
                                   glslang::TIntermTyped* right, const glslang::TType& type);

}  // namespace penumbra::shaders
