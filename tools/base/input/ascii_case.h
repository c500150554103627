// Case-insensitive comparison of names as on the file systems of Windows or macOS, ASCII letters only.
#pragma once

#include <algorithm>
#include <string_view>

namespace penumbra {

inline char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace penumbra
