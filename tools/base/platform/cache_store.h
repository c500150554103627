// Answers on disk, each under the hash of all it depends on. Safe for any number of processes at once.
//
// An entry is one file, written beside its place and renamed, and carries its kind, its key and a checksum of
// all of it: a reader sees a whole entry or none. One that is truncated or damaged reads as absent, is
// counted, and is written again. There are no locks, and nothing is flushed to the disk: after a power cut
// entries may be damaged, which is found. Writing is an attempt: a full or read-only disk costs the next run
// its time.
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
  // An empty path keeps nothing. The folder is made on the first write.
  explicit CacheStore(std::filesystem::path directory) : directory_(std::move(directory)) {}

  // kind: what the content is, lower-case letters and digits; the extension of its files. A change of what it
  // means takes another. key: 32 hexadecimal digits (ContentHash).
  std::optional<std::string> find(std::string_view kind, const std::string& key) const;
  // False when it cannot be written (full disk, permissions): nothing partial is left.
  bool store(std::string_view kind, const std::string& key, std::string_view content) const;
  void drop(std::string_view kind, const std::string& key) const;

  std::filesystem::path file(std::string_view kind, const std::string& key) const;

  std::size_t damaged() const { return damaged_; }          // entries met that were not whole
  std::uint64_t bytes_written() const { return written_; }  // by this object

 private:
  std::filesystem::path directory_;
  mutable std::atomic<std::size_t> damaged_{0};
  mutable std::atomic<std::uint64_t> written_{0};
};

// Removes the entries of these kinds that were used longest ago until the rest of them has at most `limit`
// bytes, and what killed processes left half-written an hour ago or more. Entries in use are whole until
// their readers close them. The bytes that are left.
std::uint64_t trim_cache(const std::filesystem::path& directory, std::span<const std::string_view> kinds,
                         std::uint64_t limit);

// The same when this run alone, which wrote so many bytes, has written a good part of what fits, and else
// once a day: looking at every entry takes time that a small run should not pay. An empty directory has
// nothing.
void trim_cache_when_due(const std::filesystem::path& directory, std::span<const std::string_view> kinds,
                         std::uint64_t limit, std::uint64_t written);

}  // namespace penumbra::platform
