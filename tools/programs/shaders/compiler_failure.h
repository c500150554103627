// The diagnostic for a compiling worker that has crashed, hung or exceeded a limit.
#pragma once

#include <string>

#include "platform/worker_pool.h"

namespace penumbra::shaders {

struct CompilerFailure {
  std::string problem;  // "the compiler crashed with SIGSEGV", and the end of its output
  std::string remedy;
  bool limited = false;  // true if it exceeded a limit of time or memory
};

// Describes an outcome without a response.
CompilerFailure compiler_failure(const platform::WorkerOutcome& outcome);

}  // namespace penumbra::shaders
