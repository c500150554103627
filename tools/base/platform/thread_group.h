// Several threads that do the same work.
#pragma once

#include <functional>

namespace penumbra::platform {

// Calls `work` on this thread and on up to threads - 1 others, fewer if the system starts no more; returns
// when all have returned. The calls divide the work through shared state, and must not throw.
void run_on_threads(unsigned threads, const std::function<void()>& work);

}  // namespace penumbra::platform
