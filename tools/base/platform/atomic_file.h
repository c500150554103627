// Files that are either whole or not there: they are written beside their place, flushed, and renamed over
// it.
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

namespace penumbra::platform {

// Throws penumbra::InputError naming the file and the system's reason (full disk, no permission, no such
// folder); the old content, if any, stays, and the temporary file is removed. A target that is not a regular
// file, such as /dev/null, is written to directly. Links that a checkout holds are not
// followed: one in the file's place is replaced, and one on the way to its folder is refused.
void write_file_atomically(const std::filesystem::path& file, std::string_view content);
void write_file_atomically(const std::filesystem::path& file, std::span<const std::byte> content);

struct FileContent {
  std::filesystem::path file;
  std::string_view content;
};

// A temporary file beside another one, with a random name. It is removed unless it is renamed, even if memory
// runs out.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& file);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::FILE* stream() { return stream_; }  // null if the file could not be made, for the reason in errno
  bool close();
  std::error_code rename(const std::filesystem::path& file);

 private:
  std::filesystem::path path_;
  std::FILE* stream_ = nullptr;
  bool renamed_ = false;
};

// Writes files that belong together, such as a bake's pictures and the file that names them: where one cannot
// be written or put in its place, all of the old ones stay. They are replaced in this order.
void write_files_atomically(const std::vector<FileContent>& files);

std::string_view text_of(std::span<const std::byte> bytes);

// Throws what write_file_atomically would throw, but for a disk that is full then; leaves nothing behind.
void check_file_can_be_written(const std::filesystem::path& file);

// Throws the same for any file in a folder that is there; the message names `named`.
void check_folder_can_be_written(const std::filesystem::path& folder, const std::filesystem::path& named);

// Returns whether the file is the folder or below it, by their names alone.
bool is_below(const std::filesystem::path& file, const std::filesystem::path& folder);

// Returns the first part of the path below the folder that is a link.
std::optional<std::filesystem::path> link_below(const std::filesystem::path& folder,
                                                const std::filesystem::path& path);

// Returns the first part of the path that is a link, below the current folder or below the folder of the git
// repository that the path lies in. Links above them, or elsewhere, are the system's and the user's.
std::optional<std::filesystem::path> link_of_checkout(const std::filesystem::path& path);

}  // namespace penumbra::platform
