// SIGINT (Ctrl-C) and SIGTERM as a flag that long loops poll, so that no partial output is left.
#pragma once

#include <exception>

namespace penumbra::platform {

class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

inline constexpr const char* interrupted_message =
    "interrupted; the same command continues with what is in the cache";

// A write past the limit on the size of files (SIGXFSZ) fails with EFBIG from then on, and does not end the
// program. SIGINT and SIGTERM set the flag. Code that does not poll it, such as a long dispatch on the CPU,
// is ended after two seconds; another signal, a second or more after the first, ends the program immediately.
// The exit code is 128 plus the signal's number.
void watch_interrupts();
bool interrupted();
int interrupting_signal();    // 0: none
void throw_if_interrupted();  // throws Interrupted

// While an object exists, a file is being written, and the end after two seconds is delayed. Thread-safe.
class FileWrite {
 public:
  FileWrite();
  ~FileWrite();
  FileWrite(const FileWrite&) = delete;
  FileWrite& operator=(const FileWrite&) = delete;
};

}  // namespace penumbra::platform
