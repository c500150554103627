#include "platform/cache_folder.h"

#include <array>
#include <cstdlib>
#include <system_error>

#ifndef _WIN32
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace penumbra::platform {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

fs::path user_folder() {
  if (const std::string given = environment("PENUMBRA_CACHE"); !given.empty()) return given;
  // A relative path is to be ignored (XDG Base Directory Specification).
  if (const fs::path xdg = environment("XDG_CACHE_HOME"); xdg.is_absolute()) return xdg / "penumbra";
#ifdef _WIN32
  const fs::path home = environment("LOCALAPPDATA");
#else
  const fs::path home = environment("HOME");
#endif
  // A user without a home has a path there, too, which is not to be made.
  std::error_code error;
  const bool is_there = home.is_absolute() && fs::is_directory(home, error);
  return is_there ? home / ".cache" / "penumbra" : fs::path();
}

}  // namespace

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
