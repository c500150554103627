// The same work on several threads.
#pragma once

#include <functional>

namespace penumbra::platform {

// Calls `work` on this thread and on up to threads - 1 more at once, on fewer where the system starts no
// more; returns when all of them have. `work` takes its share from what they have in common, and throws
// nothing.
void run_on_threads(unsigned threads, const std::function<void()>& work);

}  // namespace penumbra::platform
