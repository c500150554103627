// Case-insensitive file lookup, as on the file systems of Windows and macOS (ASCII letters only). Internal to
// this folder.
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra::project {

// Returns every file whose path below `base` is `rest` up to case, sorted; at most a handful. `base` itself
// is case-sensitive.
std::vector<std::filesystem::path> files_ignoring_case(const std::filesystem::path& base,
                                                       const std::filesystem::path& rest);

}  // namespace penumbra::project
