#include "platform/thread_group.h"

#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace penumbra::platform {

void run_on_threads(unsigned threads, const std::function<void()>& work) {
  std::vector<std::thread> others;
  try {
    while (others.size() + 1 < threads) others.emplace_back(std::cref(work));
  } catch (const std::system_error&) {  // no more threads can be started: the work takes longer
  } catch (const std::bad_alloc&) {
  }
  work();
  for (std::thread& other : others) other.join();
}

}  // namespace penumbra::platform
