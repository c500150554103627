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

std::atomic<Clock::rep> first_time = 0;  // time of the first signal; 0 before it
std::atomic<int> first_signal = 0;
std::atomic<int> open_writes = 0;
static_assert(std::atomic<Clock::rep>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler uses them");

void say(std::string_view text) {
#ifdef _WIN32
  (void)::_write(2, text.data(), static_cast<unsigned>(text.size()));
#else
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
#endif
}

#ifdef _WIN32
void end_after_grace() {}
#else
constexpr unsigned kGraceSeconds = 2;

extern "C" void end_at_last(int /*signal_number*/) {
  if (open_writes > 0) {
    ::alarm(1);
    return;
  }
  say("penumbra: ");
  say(interrupted_message);
  say("\n");
  std::_Exit(128 + first_signal);
}

void end_after_grace() {
  ::alarm(kGraceSeconds);
}
#endif

extern "C" void take_interrupt(int signal_number) {
  const Clock::rep now = Clock::now().time_since_epoch().count();
  Clock::rep first = 0;
  if (first_time.compare_exchange_strong(first, now)) {
    first_signal = signal_number;
    end_after_grace();
    return;
  }
  // timeout(1) and some shells send one request twice, to the program and to its group.
  if (Clock::duration(now - first) < std::chrono::seconds(1)) return;
  say("penumbra: ended at once by a second signal\n");
  std::_Exit(128 + signal_number);
}

}  // namespace

void watch_interrupts() {
#ifndef _WIN32
  std::signal(SIGALRM, end_at_last);
  std::signal(SIGXFSZ, SIG_IGN);  // a write past the limit fails with EFBIG, and is reported
#endif
  std::signal(SIGINT, take_interrupt);
  std::signal(SIGTERM, take_interrupt);
}

bool interrupted() {
  return first_signal != 0;
}

int interrupting_signal() {
  return first_signal;
}

void throw_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

FileWrite::FileWrite() {
  ++open_writes;
}

FileWrite::~FileWrite() {
  --open_writes;
}

}  // namespace penumbra::platform
