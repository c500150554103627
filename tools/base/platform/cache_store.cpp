#include "platform/cache_store.h"

#ifndef _WIN32
#include <pwd.h>
#include <sys/stat.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <vector>

#include "platform/atomic_file.h"
#include "platform/content_hash.h"

namespace penumbra::platform {
namespace {

namespace fs = std::filesystem;

std::string environment_value(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

fs::path user_folder() {
  if (const std::string given = environment_value("PENUMBRA_CACHE"); !given.empty()) return given;
  // A relative path is to be ignored (XDG Base Directory Specification).
  if (const fs::path xdg = environment_value("XDG_CACHE_HOME"); xdg.is_absolute()) return xdg / "penumbra";
#ifdef _WIN32
  const fs::path home = environment_value("LOCALAPPDATA");
#else
  const fs::path home = environment_value("HOME");
#endif
  // A user without a home has a path there, too, which is not to be made.
  std::error_code error;
  const bool is_there = home.is_absolute() && fs::is_directory(home, error);
  return is_there ? home / ".cache" / "penumbra" : fs::path();
}

constexpr std::string_view title = "penumbra cache 1 ";
constexpr std::string_view part_extension = ".part";
constexpr std::size_t hash_size = content_hash_digits;
// A use is recorded at most this often: the order of removal does not need a finer resolution.
constexpr std::chrono::minutes use_grain{10};

std::string head_of(std::string_view kind, const std::string& key) {
  return std::string(title).append(kind).append("\n").append(key);
}

std::string hash_of(std::string_view content) {
  return ContentHash().update(content).hex();
}

// No entry is larger: a module, sources or a picture of a reference.
constexpr std::uintmax_t largest_entry = std::uintmax_t{1} << 28U;

// A folder or a pipe in an entry's place, and a file that is too large for one, count as absent.
std::optional<std::string> read_file(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  const std::uintmax_t size = fs::file_size(file, ignored);
  if (ignored || size > largest_entry) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  stream.seekg(0, std::ios::end);
  std::string content(static_cast<std::size_t>(std::max<std::streamoff>(stream.tellg(), 0)), '\0');
  stream.seekg(0);
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(stream.gcount()));
  return content;
}

bool write_file(const fs::path& file, std::string_view content) {
  std::optional<TemporaryFile> part(std::in_place, file);
  if (part->stream() == nullptr) {
    if (!make_cache_folder(file.parent_path())) return false;
    part.emplace(file);
    if (part->stream() == nullptr) return false;
  }
  const bool written = std::fwrite(content.data(), 1, content.size(), part->stream()) == content.size();
  return part->close() && written && !part->rename(file);
}

// A symbolic link in a folder that others can write to may refer to a file outside of the cache.
void mark_used(const fs::path& file) {
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(file, error))) return;
  const fs::file_time_type now = fs::file_time_type::clock::now();
  const fs::file_time_type before = fs::last_write_time(file, error);
  if (!error && now - before > use_grain) fs::last_write_time(file, now, error);
}

struct KeptFile {
  fs::path file;
  fs::file_time_type used;
  std::uint64_t size = 0;
};

// Returns whether this file belongs to the cache and may be removed, whatever else is in the folder.
bool is_own(const fs::path& file, std::span<const std::string_view> kinds) {
  const std::string extension = file.extension().string();
  const std::string folder = file.parent_path().filename().string();
  const std::string name = file.stem().string();
  constexpr const char* digits = "0123456789abcdef";
  if (folder.size() != 2 || folder.find_first_not_of(digits) != std::string::npos) return false;
  if (extension == part_extension) return name.front() == '.';
  // The name may have any length, because keys of earlier versions were shorter.
  return name.find_first_not_of(digits) == std::string::npos && extension.starts_with('.') &&
         std::find(kinds.begin(), kinds.end(), std::string_view(extension).substr(1)) != kinds.end();
}

// Returns all entries; also removes orphaned temporary files of ended processes.
std::vector<KeptFile> entries_in(const fs::path& directory, std::span<const std::string_view> kinds) {
  const fs::file_time_type long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  std::vector<KeptFile> entries;
  std::error_code error;
  for (fs::recursive_directory_iterator it(directory, error), end; !error && it != end; it.increment(error)) {
    std::error_code gone;  // another process may remove it meanwhile
    if (!it->is_regular_file(gone) || gone || !is_own(it->path(), kinds)) continue;
    KeptFile entry{it->path(), it->last_write_time(gone), it->file_size(gone)};
    if (gone) continue;
    if (entry.file.extension() != part_extension)
      entries.push_back(std::move(entry));
    else if (entry.used < long_ago)
      fs::remove(entry.file, gone);
  }
  return entries;
}

}  // namespace

CacheStore::CacheStore(fs::path directory) {
  if (cache_folder_problem(directory).empty()) directory_ = std::move(directory);
}

fs::path CacheStore::file(std::string_view kind, const std::string& key) const {
  return directory_ / key.substr(0, 2) / key.substr(2).append(".").append(kind);
}

std::optional<std::string> CacheStore::find(std::string_view kind, const std::string& key) const {
  if (directory_.empty()) return std::nullopt;
  const fs::path place = file(kind, key);
  if (!cache_folder_problem(place.parent_path()).empty()) return std::nullopt;
  const std::optional<std::string> content = read_file(place);
  if (!content) return std::nullopt;
  const std::string head = head_of(kind, key);
  const std::string_view whole = *content;
  const bool sound =
      whole.size() >= head.size() + hash_size && whole.starts_with(head) &&
      hash_of(whole.substr(0, whole.size() - hash_size)) == whole.substr(whole.size() - hash_size);
  if (!sound) {
    ++damaged_;
    return std::nullopt;
  }
  mark_used(place);
  return std::string(whole.substr(head.size(), whole.size() - head.size() - hash_size));
}

bool CacheStore::store(std::string_view kind, const std::string& key, std::string_view content) const {
  if (directory_.empty()) return false;
  const fs::path place = file(kind, key);
  if (!cache_folder_problem(place.parent_path()).empty()) return false;
  std::string entry = head_of(kind, key);
  if (entry.size() + content.size() + hash_size > largest_entry) return false;
  entry += content;
  entry += hash_of(entry);
  if (!write_file(place, entry)) return false;
  written_ += entry.size();
  return true;
}

void CacheStore::drop(std::string_view kind, const std::string& key) const {
  std::error_code ignored;
  if (!directory_.empty()) fs::remove(file(kind, key), ignored);
}

std::uint64_t trim_cache(const fs::path& directory, std::span<const std::string_view> kinds,
                         std::uint64_t limit) {
  std::vector<KeptFile> entries = entries_in(directory, kinds);
  std::sort(entries.begin(), entries.end(), [](const KeptFile& a, const KeptFile& b) {
    return a.used != b.used ? a.used < b.used : a.file < b.file;
  });
  std::uint64_t total = 0;
  for (const KeptFile& entry : entries) total += entry.size;
  for (const KeptFile& entry : entries) {
    if (total <= limit) break;
    std::error_code error;
    fs::remove(entry.file, error);
    if (!error) total -= entry.size;
  }
  return total;
}

void trim_cache_when_due(const fs::path& directory, std::span<const std::string_view> kinds,
                         std::uint64_t limit, std::uint64_t written) {
  if (directory.empty() || written == 0) return;
  const fs::path stamp = directory / "trimmed";
  std::error_code error;
  const fs::file_time_type last = fs::last_write_time(stamp, error);
  const bool lately = !error && fs::file_time_type::clock::now() - last < std::chrono::hours(24);
  if (lately && written < limit / 64) return;
  trim_cache(directory, kinds, limit);
  write_file(stamp, "by the limit in force, at the date of this file\n");
}

fs::path cache_directory(std::string_view part) {
  const fs::path folder = user_folder();
  return folder.empty() || part.empty() ? folder : folder / part;
}

#ifdef _WIN32

fs::path listed_home() {
  return {};
}

std::string cache_folder_problem(const fs::path&) {
  return {};  // the user's profile is the user's own
}

bool make_cache_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  return !error;
}

#else

fs::path listed_home() {
  std::array<char, 16384> memory{};
  passwd entry{};
  passwd* found = nullptr;
  if (getpwuid_r(getuid(), &entry, memory.data(), memory.size(), &found) != 0 || found == nullptr) return {};
  return entry.pw_dir == nullptr ? "" : entry.pw_dir;
}

std::string cache_folder_problem(const fs::path& folder) {
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) return {};
  if (status.st_uid != ::geteuid()) return "'" + folder.string() + "' belongs to another user";
  if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0)
    return "others can write to '" + folder.string() +
           "' (remove it, or trust what is in it and take that right away: chmod go-w)";
  return {};
}

bool make_cache_folder(const fs::path& folder) {
  fs::path reached;
  for (const fs::path& part : folder) {
    reached /= part;
    ::mkdir(reached.c_str(), S_IRWXU);  // fails for folders that exist
  }
  std::error_code error;
  return fs::is_directory(folder, error) && cache_folder_problem(folder).empty();
}

#endif

}  // namespace penumbra::platform
