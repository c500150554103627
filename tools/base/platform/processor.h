// What this machine computes with, for the head of a result table.
#pragma once

#include <string>

namespace penumbra::platform {

// "<model name>, <n> threads"; "unknown processor" where the system does not say.
std::string processor_name();

}  // namespace penumbra::platform
