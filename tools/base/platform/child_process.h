// Runs another program to completion: arguments without a shell, text in, text out, with a timeout.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace penumbra::platform {

struct ChildCommand {
  std::string program;  // a path, or a name that is searched in PATH
  std::vector<std::string> arguments;
  std::string input;                                  // all of its standard input
  std::chrono::milliseconds timeout{300'000};         // ends a child that hangs; generous for a busy machine
  std::size_t output_limit = std::size_t{256} << 20;  // bytes of output and errors together
  std::vector<std::pair<std::string, std::string>> environment{};  // added to ours, or replacing ours
};

// The signal that ends a child at its own CPU time limit; 0 if there is no such signal.
extern const int signal_of_processor_time;

struct ChildResult {
  int exit_code = 0;        // 128 + signal when a signal ended it
  bool timed_out = false;   // killed, with everything it started, at the timeout
  bool overflowed = false;  // killed because it wrote more than output_limit
  std::string output;       // standard output, complete
  std::string errors;       // standard error, complete

  bool succeeded() const { return exit_code == 0 && !timed_out && !overflowed; }
};

// Throws EnvironmentError if the program cannot be started, Interrupted if the user interrupts (the child is
// ended first). POSIX only: elsewhere it throws EnvironmentError.
ChildResult run_child(const ChildCommand& command);

// Returns the program's path, which PATH leads to; empty if there is none.
std::optional<std::filesystem::path> find_program(const std::string& name);

}  // namespace penumbra::platform
