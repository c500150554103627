// The part of its parent's environment that a worker process sees; the environment can hold keys and
// passwords. Internal to this folder.
#pragma once

#include <string>
#include <vector>

namespace penumbra::platform {

// Returns NAME=VALUE of each variable of this process that a worker or its graphics driver reads, and of no
// other.
std::vector<std::string> worker_environment();

}  // namespace penumbra::platform
