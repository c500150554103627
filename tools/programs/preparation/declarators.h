// The variables of one declaration: `static float4 a, b[2][3] = { ... }, c : register(c1);`. Internal to this
// folder.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

struct Declarator {
  std::string type;  // the type without storage classes and modifiers: "float4", "Texture2D<float4>"
  bool is_static = false;
  bool is_const = false;
  bool is_groupshared = false;
  std::size_t name = 0;
  std::size_t dimensions = 0;       // the first '[' after the name
  std::size_t dimension_count = 0;  // tokens of all [..] together; 0 for no array
  std::size_t initialiser = npos;   // the token after '='
  std::size_t end = 0;              // the ',' or ';' after it
};

// Returns the declarators of the declaration that begins at `first` (attributes skipped) and ends at the ';'
// at `last`. The result is empty if the tokens are not such a declaration.
std::vector<Declarator> declarators(const TokenText& text, std::size_t first, std::size_t last);

// Returns whether the word is float, half3, min16float4x4, ...: a scalar, vector or matrix of numbers or
// bools, written as one identifier.
bool is_number_type(std::string_view word);

}  // namespace penumbra::preparation
