// Finds pictures again in the picture that they were put into.
#pragma once

#include "study/picture.h"

namespace penumbra::study {

// The number of times that a picture occurs unchanged in another.
inline int occurrences(const Picture& whole, const Picture& part) {
  int count = 0;
  for (int top = 0; top + part.height <= whole.height; ++top) {
    for (int left = 0; left + part.width <= whole.width; ++left) {
      bool same = true;
      for (int i = 0; same && i < part.width * part.height; ++i) {
        const int x = i % part.width;
        const int y = i / part.width;
        same = pixel(whole, left + x, top + y) == pixel(part, x, y);
      }
      count += same ? 1 : 0;
    }
  }
  return count;
}

}  // namespace penumbra::study
