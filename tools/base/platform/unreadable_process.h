// Keeps worker processes from reading the memory and the environment of the process that started them. It
// does so on Linux, and nothing elsewhere. Internal to this folder.
#pragma once

namespace penumbra::platform {

// While an object exists, processes of the same user cannot read this process through /proc or trace it,
// unless they may read every process; it writes no core file.
class UnreadableProcess {
 public:
  UnreadableProcess();
  ~UnreadableProcess();
  UnreadableProcess(const UnreadableProcess&) = delete;
  UnreadableProcess& operator=(const UnreadableProcess&) = delete;
};

// This thread, and those that it starts, may not read every process from now on, even as root.
void give_up_reading_processes();

}  // namespace penumbra::platform
