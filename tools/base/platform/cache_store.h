// A cache on disk, keyed by the hash of everything that a result depends on. Concurrent processes may share
// it.
//
// An entry is one file, written to a temporary file and renamed, and contains its kind, its key and a
// checksum: a reader sees a whole entry or none. A truncated or damaged entry counts as absent, is counted,
// and is written again. There are no locks and no flushes: entries damaged by a power cut are detected. Write
// errors are not fatal: with a full or read-only disk, the next run has to recompute.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace penumbra::platform {

class CacheStore {
 public:
  // An empty path disables the cache, and so does a folder with a cache_folder_problem(). The folder is
  // created by the first write, for this user alone.
  explicit CacheStore(std::filesystem::path directory);

  // `kind` is the type of the content, in lower-case letters and digits, and the extension of its files. A
  // change of its format needs a new kind. `key` is a ContentHash::hex().
  std::optional<std::string> find(std::string_view kind, const std::string& key) const;
  // Returns false if it cannot be written (full disk, permissions) or is larger than what find() reads: no
  // partial file is left.
  bool store(std::string_view kind, const std::string& key, std::string_view content) const;
  void drop(std::string_view kind, const std::string& key) const;

  std::filesystem::path file(std::string_view kind, const std::string& key) const;

  std::size_t damaged() const { return damaged_; }          // damaged entries that were read
  std::uint64_t bytes_written() const { return written_; }  // total of this object

 private:
  std::filesystem::path directory_;
  mutable std::atomic<std::size_t> damaged_{0};
  mutable std::atomic<std::uint64_t> written_{0};
};

// Removes the least recently used entries of these kinds until at most `limit` bytes are left, and temporary
// files that killed processes left an hour ago or more. Entries that are being read stay intact until their
// readers close them. Returns the remaining bytes.
std::uint64_t trim_cache(const std::filesystem::path& directory, std::span<const std::string_view> kinds,
                         std::uint64_t limit);

// Trims as above if this run has written a large part of the limit, otherwise at most once a day, because
// examining every entry takes time. An empty directory has no entries.
void trim_cache_when_due(const std::filesystem::path& directory, std::span<const std::string_view> kinds,
                         std::uint64_t limit, std::uint64_t written);

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
