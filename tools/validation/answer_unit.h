// What a worker does with one unit: makes its text, and unless the answer is known, compiles it and tries
// every target.
#pragma once

#include <string>

#include "platform/worker_pool.h"

namespace penumbra::validation {

// The handler of worker processes and of threads: an encoded UnitJob to an encoded UnitReply. Bad shaders are
// in the reply. Throws EnvironmentError when a target's driver is not there.
std::string answer_unit(const std::string& job, platform::WorkerLink& link);

}  // namespace penumbra::validation
