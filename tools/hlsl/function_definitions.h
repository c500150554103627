// Which functions a preprocessed HLSL text defines, with the types they take. Internal to this room.
//
// Reads declarations, not expressions: functions at file scope and in namespaces. Functions of structs are
// left out (nothing may declare them a second time), and so is what a text with unbalanced brackets holds
// after the place where it goes wrong.
#pragma once

#include <string>
#include <vector>

#include "hlsl/tokens.h"

namespace penumbra::hlsl {

struct FunctionDefinition {
  std::string name;                     // with its namespaces: "A::f"
  std::vector<std::string> parameters;  // "out half2[4]": direction unless it is in, type, array sizes
  const Token* name_token = nullptr;
  const Token* body_begin = nullptr;  // '{'
  const Token* body_end = nullptr;    // its '}'
};

// In the order of the text; the pointers are into `tokens`.
std::vector<FunctionDefinition> function_definitions(const std::vector<Token>& tokens);

}  // namespace penumbra::hlsl
