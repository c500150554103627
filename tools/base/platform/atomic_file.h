// Files that are either whole or not there: written beside their place, flushed, then renamed over it.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace penumbra::platform {

// Throws penumbra::InputError naming the file and the system's reason (full disk, no permission, no such
// folder); the old content, if any, stays, and the temporary file is removed. A target that is not a regular
// file, such as /dev/null, is written to directly.
void write_file_atomically(const std::filesystem::path& file, std::string_view content);
void write_file_atomically(const std::filesystem::path& file, std::span<const std::byte> content);

// Throws what write_file_atomically would throw, but for a disk that is full then; leaves nothing behind.
void check_file_can_be_written(const std::filesystem::path& file);

// The same of any file in a folder that is there; the message names `named`.
void check_folder_can_be_written(const std::filesystem::path& folder, const std::filesystem::path& named);

}  // namespace penumbra::platform
