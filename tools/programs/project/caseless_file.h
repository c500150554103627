// A file found as disks of Windows and macOS find it, where case (of ASCII letters) does not count. Internal
// to this room.
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra::project {

// Every file whose path below `base` is `rest` but for case, sorted; at most a handful. The case of `base`
// counts.
std::vector<std::filesystem::path> files_ignoring_case(const std::filesystem::path& base,
                                                       const std::filesystem::path& rest);

}  // namespace penumbra::project
