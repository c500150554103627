// Measures processor time of this process, for tests of how work grows. It has neither other programs' load
// nor the system's time, which is for new pages of memory and depends on the machine's state.
#pragma once

#include <sys/resource.h>

#include <functional>

namespace penumbra {

inline double user_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

inline double processor_seconds(const std::function<void()>& work) {
  const double begin = user_seconds();
  work();
  return user_seconds() - begin;
}

}  // namespace penumbra
