// The declarations at file scope (and in namespaces) of a preprocessed HLSL text: functions, structs,
// buffers, variables, each with its tokens.
//
// The parser reads declarations, not expressions, and is linear in the number of tokens. In a text with
// unbalanced brackets, everything after the error is ignored. members() and the callers read the contents of
// structs and functions.
#pragma once

#include "hlsl/tokens.h"

namespace penumbra::hlsl {

struct Declaration {
  // A prototype is a function without a body; a structure is a struct, class or interface; a buffer is a
  // cbuffer or tbuffer; empty is a lone ';'.
  enum class Kind { function, prototype, structure, buffer, variable, alias, empty, other };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Kind kind = Kind::other;
  std::string scope;                   // the enclosing namespaces: "A::B::", or empty
  std::size_t first = 0;               // its first token, including attributes
  std::size_t type = 0;                // its first token after attributes
  std::size_t last = 0;                // its last token: ';', or '}' if no ';' follows
  std::size_t name = none;             // the token of its name (for a variable, of the first declarator)
  std::size_t parameters_open = none;  // '(' and ')' around a function's parameters
  std::size_t parameters_close = none;
  std::size_t open = none;  // '{' and '}' around a body, members, or sampler states
  std::size_t close = none;
};

// Returns the declarations in source order.
std::vector<Declaration> read_declarations(const std::vector<Token>& tokens);

// Returns the types of a function's parameters: "out half2[4]": direction unless it is in, type, array sizes.
std::vector<std::string> parameter_types(const std::vector<Token>& tokens, const Declaration& function);

}  // namespace penumbra::hlsl
