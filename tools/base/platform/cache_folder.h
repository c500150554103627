// The user's home, and the folder in which results are kept. That folder's content is taken as this program's
// own, so only the user may be able to write there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace penumbra::platform {

// Returns the home folder of the system's list of users, whatever HOME says; empty for a user whom it does
// not list, and on Windows.
std::filesystem::path listed_home();

// Returns $PENUMBRA_CACHE, else $XDG_CACHE_HOME/penumbra or ~/.cache/penumbra, and a folder of the name
// `part` in it. The result is empty if no variable of the environment names a place that is the user's own.
std::filesystem::path cache_directory(std::string_view part = {});

// Says why nothing may be kept in this folder: another user owns it, or others can write to it. Empty where
// it may be used, and for one that does not exist yet.
std::string cache_folder_problem(const std::filesystem::path& folder);

// Makes the folder and those above it that are missing, for this user alone (mode 0700). Returns false if it
// cannot be made, or has a problem.
bool make_cache_folder(const std::filesystem::path& folder);

}  // namespace penumbra::platform
