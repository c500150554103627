// Folder listings, sorted by name so that results do not depend on the file system. Internal to this folder.
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra::project {

// Returns the folders in a folder, including symbolic links to folders. Throws InputError if it cannot be
// listed.
std::vector<std::filesystem::path> folders_in(const std::filesystem::path& folder);

// Returns whether a directory entry of that name exists, including a dangling symbolic link.
bool is_there(const std::filesystem::path& file);

}  // namespace penumbra::project
