// The characters of HLSL and of its preprocessor, and its identifiers.
#pragma once

#include <algorithm>
#include <string_view>

namespace penumbra::hlsl {

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

// Returns whether an identifier may begin with this character.
constexpr bool begins_identifier(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// Returns whether an identifier may contain this character after the first.
constexpr bool continues_identifier(char c) {
  return begins_identifier(c) || is_digit(c);
}

inline bool is_identifier(std::string_view name) {
  return !name.empty() && begins_identifier(name.front()) &&
         std::all_of(name.begin(), name.end(), continues_identifier);
}

}  // namespace penumbra::hlsl
