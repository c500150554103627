// The message and the exit code for an exception.
#pragma once

#include <exception>
#include <string>

#include "cli/subcommand.h"

namespace penumbra::cli {

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
