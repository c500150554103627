#include "faults/injected_fault.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include "faults/fault_counter.h"

namespace penumbra::faults {
namespace {

struct State {
  std::atomic<bool> armed{false};
  std::atomic<std::size_t> calls{0};
  std::atomic<bool> happened{false};
  Kind kind = Kind::memory;
  Extent extent = Extent::once;
  std::size_t number = 0;
};
State state;
thread_local int sheltered = 0;

bool fails_now() {
  const std::size_t call = state.calls++;
  const bool fails = state.extent == Extent::once ? call == state.number : call >= state.number;
  if (fails) state.happened = true;
  return fails;
}

}  // namespace

bool allocation_fails() {
  return state.armed && sheltered == 0 && state.kind == Kind::memory && fails_now();
}

int file_call_fails(FileCall call) {
  if (!state.armed || sheltered != 0 || state.kind == Kind::memory) return 0;
  if (state.kind == Kind::full && call == FileCall::reads) return 0;  // a full disk can be read
  if (!fails_now()) return 0;
  return state.kind == Kind::full ? ENOSPC : EIO;
}

InjectedFault::InjectedFault(Kind kind, Extent extent, std::size_t number) {
  state.kind = kind;
  state.extent = extent;
  state.number = number;
  state.calls = 0;
  state.happened = false;
  state.armed = true;
}

InjectedFault::~InjectedFault() {
  state.armed = false;
}

bool InjectedFault::happened() const {
  return state.happened;
}

NoFault::NoFault() {
  ++sheltered;
}

NoFault::~NoFault() {
  --sheltered;
}

std::size_t open_files() {
  const NoFault shelter;
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {}));
}

}  // namespace penumbra::faults
