// The files that a process may open, restricted by Landlock (Linux 5.13 and later). Internal to this folder.
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra::platform {

// The restriction is irrevocable, for this process and those that it starts: they may read and execute what
// is in `readable`, and also write and create what is in `writable`. Where the kernel has no Landlock,
// nothing changes.
void allow_files(const std::vector<std::filesystem::path>& readable,
                 const std::vector<std::filesystem::path>& writable);

}  // namespace penumbra::platform
