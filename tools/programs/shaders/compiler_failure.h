// What to say when a worker that compiled has died, hung or taken too much.
#pragma once

#include <string>

#include "platform/worker_pool.h"

namespace penumbra::shaders {

struct CompilerFailure {
  std::string problem;  // "the compiler crashed with SIGSEGV", and what it said last
  std::string way_out;
};

// Of an outcome without an answer.
CompilerFailure compiler_failure(const platform::WorkerOutcome& outcome);

}  // namespace penumbra::shaders
