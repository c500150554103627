#include "platform/interrupt.h"

#include <csignal>
#include <cstdlib>

namespace penumbra::platform {
namespace {

volatile std::sig_atomic_t interrupt_count = 0;

extern "C" void count_interrupt(int signal_number) {
  interrupt_count = interrupt_count + 1;
  if (interrupt_count > 1) std::_Exit(128 + signal_number);
}

}  // namespace

void watch_interrupts() {
  std::signal(SIGINT, count_interrupt);
  std::signal(SIGTERM, count_interrupt);
}

bool interrupted() {
  return interrupt_count > 0;
}

void throw_if_interrupted() {
  if (interrupted()) throw Interrupted();
}

}  // namespace penumbra::platform
