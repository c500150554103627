// What a person is told, and a script is answered, when something was thrown.
#pragma once

#include <exception>
#include <string>

#include "cli/subcommand.h"

namespace penumbra::cli {

struct Failure {
  ExitCode code;
  std::string message;  // without the program's name before it
};

// What is no error of input, environment or memory, and no interruption, is a mistake in the program.
Failure failure_of(const std::exception_ptr& thrown);

// An exception that cannot be caught ends the program with the exit code of memory that has run out, if it is
// that, and not with SIGABRT: destructors of JSON documents and the C++ library's directory iterators need
// memory.
void answer_uncaught_exceptions();

}  // namespace penumbra::cli
