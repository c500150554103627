// What stands at file scope (and in namespaces) of a preprocessed HLSL text: functions, structs, buffers,
// variables, each with the tokens it consists of.
//
// Reads declarations, not expressions; linear in the number of tokens. What a text with unbalanced brackets
// holds after the place where it goes wrong is left out. The insides of structs and functions are left to
// members() and to whoever asks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hlsl/tokens.h"

namespace penumbra::hlsl {

struct Declaration {
  // prototype: a function without a body; structure: struct, class or interface; buffer: cbuffer or tbuffer;
  // empty: a ';' of its own.
  enum class Kind { function, prototype, structure, buffer, variable, alias, empty, other };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Kind kind = Kind::other;
  std::string scope;                   // the namespaces it stands in: "A::B::", or empty
  std::size_t first = 0;               // its first token, attributes included
  std::size_t type = 0;                // its first token after attributes
  std::size_t last = 0;                // its last token: ';', or '}' where no ';' follows
  std::size_t name = none;             // the token that names it (of a variable, the first declarator)
  std::size_t parameters_open = none;  // '(' and ')' of a function's parameters
  std::size_t parameters_close = none;
  std::size_t open = none;  // '{' and '}' of a body, of members, or of a sampler's states
  std::size_t close = none;
};

// In the order of the text.
std::vector<Declaration> outline(const std::vector<Token>& tokens);

// The types a function takes: "out half2[4]": direction unless it is in, type, array sizes.
std::vector<std::string> parameter_types(const std::vector<Token>& tokens, const Declaration& function);

}  // namespace penumbra::hlsl
