// The folder that results are kept in. What is found there is taken as this program's own, so that nobody but
// the user may write there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace penumbra::platform {

// $PENUMBRA_CACHE, else $XDG_CACHE_HOME/penumbra or ~/.cache/penumbra, and a folder of that name in it. Empty
// where there is none: no variable of the environment names a place that is the user's own.
std::filesystem::path cache_directory(std::string_view part = {});

// Why nothing may be kept in this folder: another user owns it, or others can write to it. Empty where it may
// be used, and for one that does not exist yet.
std::string cache_folder_problem(const std::filesystem::path& folder);

// Makes the folder and those above it that are missing, for this user alone (mode 0700). False if it cannot
// be made, or has a problem.
bool make_cache_folder(const std::filesystem::path& folder);

}  // namespace penumbra::platform
