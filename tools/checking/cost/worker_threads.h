// Threads that run the same task for every index of a list.
#pragma once

#include <cstddef>
#include <functional>

namespace penumbra::cost {

// Runs task(0) .. task(count - 1), each once, on at most `jobs` threads. The first exception stops the rest
// and is thrown here; so is platform::Interrupted.
void run_all(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& task);

}  // namespace penumbra::cost
