// The program's command line as a CLI11 option tree, and one run of it.
#pragma once

#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "cli/subcommand.h"

namespace penumbra::cli {

// Returns every subcommand with its options. The tree refers to the context, which must outlive it.
std::unique_ptr<CLI::App> command_line(Context& context);

// Returns the subcommands for users: without those of worker processes.
std::vector<CLI::App*> shown_subcommands(CLI::App& app);

// Parses and runs; returns the exit code. Help and requested output go to standard output, errors to standard
// error. `arguments` are as typed, without the program's name.
int run_command_line(const std::vector<std::string>& arguments);

// The message and the exit code for an exception.
struct Failure {
  ExitCode code;
  std::string message;  // the message without the program's name
};

// An exception that is not an error of input, environment or memory, and not an interruption, is a bug in the
// program.
Failure failure_of(const std::exception_ptr& thrown);

// An exception that cannot be caught ends the program with the exit code for exhausted memory, if that is the
// cause, and not with SIGABRT: destructors of JSON documents and the C++ library's directory iterators
// allocate memory.
void answer_uncaught_exceptions();

}  // namespace penumbra::cli
