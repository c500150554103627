// Which commit of our own repository this program was built from.
#pragma once

#include <optional>
#include <string>

namespace penumbra::platform {

// git's 40 hex digits, "-dirty" behind them when tools or shaders were changed since; absent when the program
// was not built in a checkout, as from a tarball.
std::optional<std::string> source_commit();

}  // namespace penumbra::platform
