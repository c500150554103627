#include "platform/interrupt.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string_view>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace penumbra::platform {
namespace {

using Clock = std::chrono::steady_clock;

std::atomic<Clock::rep> first_signal = 0;  // when; 0 before it
static_assert(std::atomic<Clock::rep>::is_always_lock_free, "a signal handler uses it");

void say(std::string_view text) {
#ifdef _WIN32
  (void)::_write(2, text.data(), static_cast<unsigned>(text.size()));
#else
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
#endif
}

extern "C" void take_interrupt(int signal_number) {
  const Clock::rep now = Clock::now().time_since_epoch().count();
  Clock::rep first = 0;
  if (first_signal.compare_exchange_strong(first, now)) return;
  // timeout(1) and some shells send one request twice, to the program and to its group.
  if (Clock::duration(now - first) < std::chrono::seconds(1)) return;
  say("penumbra: ended at once by a second signal\n");
  std::_Exit(128 + signal_number);
}

}  // namespace

void watch_interrupts() {
  std::signal(SIGINT, take_interrupt);
  std::signal(SIGTERM, take_interrupt);
}

bool interrupted() {
  return first_signal != 0;
}

void throw_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

}  // namespace penumbra::platform
