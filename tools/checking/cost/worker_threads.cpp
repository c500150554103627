#include "cost/worker_threads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

#include "platform/interrupt.h"
#include "platform/thread_group.h"

namespace penumbra::cost {

void run_all(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        platform::throw_if_interrupted();
        task(i);
      }
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  platform::run_on_threads(static_cast<unsigned>(std::min<std::size_t>(jobs, count)), work);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace penumbra::cost
