// Text as the name of a parametrised case, which may have letters, digits and underscores alone.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace penumbra {

inline std::string as_identifier(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  return text;
}

}  // namespace penumbra
