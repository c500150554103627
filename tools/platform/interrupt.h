// Ctrl-C as a question long loops ask, so that nothing half-written is left behind.
#pragma once

#include <exception>

namespace penumbra::platform {

class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

void watch_interrupts();  // SIGINT and SIGTERM set the flag; a second one ends the program at once
bool interrupted();
void throw_if_interrupted();  // throws Interrupted

}  // namespace penumbra::platform
