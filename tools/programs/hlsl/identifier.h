// A test whether the text is an identifier of HLSL and of the preprocessor.
#pragma once

#include <algorithm>
#include <string_view>

namespace penumbra::hlsl {

inline bool is_identifier(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !name.empty() && letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

}  // namespace penumbra::hlsl
