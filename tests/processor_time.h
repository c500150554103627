// Processor time of this process, for tests of how work grows: other programs' load is not in it.
#pragma once

#include <ctime>
#include <functional>

namespace penumbra {

inline double processor_seconds(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace penumbra
