#include "platform/freed_memory.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>

#include <limits>
#endif

namespace penumbra::platform {

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int largest_of_glibc = 32 * 1024 * 1024;  // bytes; mallopt ignores greater thresholds
  mallopt(M_MMAP_THRESHOLD, largest_of_glibc);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

}  // namespace penumbra::platform
