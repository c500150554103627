// Several threads that do the same work.
#pragma once

#include <cstddef>
#include <functional>

namespace penumbra::platform {

// Calls `work` on this thread and on up to threads - 1 others, fewer if the system starts no more; returns
// when all have returned. The calls divide the work through shared state, and must not throw.
void run_on_threads(unsigned threads, const std::function<void()>& work);

// Calls task(0) .. task(count - 1), each once, on at most so many threads; 0 takes all that the machine has.
// The first exception stops the rest and is thrown here.
void run_all(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

}  // namespace penumbra::platform
