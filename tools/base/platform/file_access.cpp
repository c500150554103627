#include "platform/file_access.h"

#if defined(__linux__) && __has_include(<linux/landlock.h>)
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#endif

namespace penumbra::platform {

#if defined(__linux__) && __has_include(<linux/landlock.h>)
namespace {

// The first version of Landlock has rights up to this one.
constexpr std::uint64_t kEvery = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1U) - 1;
constexpr std::uint64_t kReading =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kOfFiles =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;

void allow(long rules, const std::filesystem::path& path, std::uint64_t access) {
  const int opened = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (opened < 0) return;
  struct stat status {};
  const bool is_folder = ::fstat(opened, &status) == 0 && S_ISDIR(status.st_mode);
  landlock_path_beneath_attr rule{};
  rule.allowed_access = is_folder ? access : access & kOfFiles;
  rule.parent_fd = opened;
  ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
  ::close(opened);
}

}  // namespace

void allow_files(const std::vector<std::filesystem::path>& readable,
                 const std::vector<std::filesystem::path>& writable) {
  landlock_ruleset_attr handled{};
  handled.handled_access_fs = kEvery;
  const long rules = ::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0);
  if (rules < 0) return;
  for (const std::filesystem::path& path : readable) allow(rules, path, kReading);
  for (const std::filesystem::path& path : writable) allow(rules, path, kEvery);
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  ::syscall(SYS_landlock_restrict_self, rules, 0);
  ::close(static_cast<int>(rules));
}

#else

void allow_files(const std::vector<std::filesystem::path>&, const std::vector<std::filesystem::path>&) {}

#endif

}  // namespace penumbra::platform
