// SIGINT (Ctrl-C) and SIGTERM as a flag that long loops ask for, so that nothing half-written is left behind.
#pragma once

#include <exception>

namespace penumbra::platform {

class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

inline constexpr const char* interrupted_message =
    "interrupted; finished work is kept, and the same command continues from there";

// SIGINT and SIGTERM set the flag. What does not ask for it, a long dispatch on the processor for example, is
// ended after two seconds; another signal, a second or more after the first, ends the program at once. The
// exit code is 128 and the signal's number.
void watch_interrupts();
bool interrupted();
int interrupting_signal();    // 0: none
void throw_if_interrupted();  // throws Interrupted

// While one is alive a file is being written, which the end after two seconds waits for. From any thread.
class FileWrite {
 public:
  FileWrite();
  ~FileWrite();
  FileWrite(const FileWrite&) = delete;
  FileWrite& operator=(const FileWrite&) = delete;
};

}  // namespace penumbra::platform
