// What a worker process sees of its parent's environment, which can hold keys and passwords. Internal to this
// folder.
#pragma once

#include <string>
#include <vector>

namespace penumbra::platform {

// NAME=VALUE of each variable of this process that a worker or its graphics driver reads, and of no other.
std::vector<std::string> worker_environment();

}  // namespace penumbra::platform
