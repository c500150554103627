// Links that a checkout holds, in the path of an output: the author of the checkout chose where they lead.
#pragma once

#include <filesystem>
#include <optional>

namespace penumbra::platform {

// Returns the first part of the path below the folder that is a link.
std::optional<std::filesystem::path> link_below(const std::filesystem::path& folder,
                                                const std::filesystem::path& path);

// Returns the first part of the path that is a link, below the current folder or below the folder of the git
// repository that the path lies in. Links above them, or elsewhere, are the system's and the user's.
std::optional<std::filesystem::path> link_of_checkout(const std::filesystem::path& path);

}  // namespace penumbra::platform
