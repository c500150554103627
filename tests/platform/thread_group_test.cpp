#include "platform/thread_group.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <mutex>
#include <set>
#include <thread>

namespace penumbra::platform {
namespace {

TEST(ThreadGroup, WorksOnAsManyThreadsAsAsked) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  std::atomic<int> waiting = 0;
  run_on_threads(5, [&] {
    ++waiting;
    while (waiting < 5) std::this_thread::yield();
    const std::lock_guard<std::mutex> lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(threads.size(), 5U);
  EXPECT_EQ(threads.count(std::this_thread::get_id()), 1U);
}

TEST(ThreadGroup, OneThreadIsTheCallersOwn) {
  std::thread::id id;
  run_on_threads(1, [&] { id = std::this_thread::get_id(); });
  EXPECT_EQ(id, std::this_thread::get_id());
}

// Exits with code 0 where some threads ran but not all.
[[noreturn]] void run_on_too_many_threads() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t room = pages * static_cast<std::size_t>(::getpagesize()) + (rlim_t{100} << 20U);
  const rlimit limit{room, room};
  ::setrlimit(RLIMIT_AS, &limit);
  std::atomic<int> ran = 0;
  run_on_threads(1000, [&] { ++ran; });
  ::_exit(ran > 0 && ran < 1000 ? 0 : 1);
}

// There is room for the stacks of some threads, not of a thousand.
TEST(ThreadGroupDeathTest, WorksOnFewerWhereTheSystemStartsNoMore) {
  EXPECT_EXIT(run_on_too_many_threads(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace penumbra::platform
