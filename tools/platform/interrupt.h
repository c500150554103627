// Ctrl-C as a question long loops ask, so that nothing half-written is left behind.
#pragma once

#include <exception>

namespace penumbra::platform {

class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

// SIGINT and SIGTERM set the flag. Another one, a second or more later, ends the program at once and says so.
void watch_interrupts();
bool interrupted();
void throw_if_interrupted();  // throws Interrupted

}  // namespace penumbra::platform
