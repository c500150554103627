// What a folder holds, sorted by name, so that nothing depends on the order of a disk, and what is there.
// Internal to this room.
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra::project {

// The folders in a folder, links to folders included. Throws InputError when it cannot be listed.
std::vector<std::filesystem::path> folders_in(const std::filesystem::path& folder);

// Whether something of that name is there, a link to nothing included.
bool is_there(const std::filesystem::path& file);

}  // namespace penumbra::project
