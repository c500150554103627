// The processor's name, for the heading of result tables.
#pragma once

#include <string>

namespace penumbra::platform {

// Returns "<model name>, <n> threads"; "unknown processor" where the system does not name it.
std::string processor_name();

}  // namespace penumbra::platform
