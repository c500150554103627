// A source location.
#pragma once

#include <string>

namespace penumbra::variants {

struct Place {
  std::string file;
  int line = 0;    // 1-based
  int column = 0;  // 1-based
};

// Returns "file:line:column".
inline std::string text_of(const Place& place) {
  return place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

}  // namespace penumbra::variants
