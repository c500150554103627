
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>

#include "platform/cache_store.h"
#include "reference/scratch_folder.h"

namespace penumbra::platform {
namespace {

namespace fs = std::filesystem;
using reference::ScratchFolder;
using testing::HasSubstr;

const std::string folder_key(64, 'a');

unsigned mode_of(const fs::path& file) {
  struct stat status {};
  EXPECT_EQ(::stat(file.c_str(), &status), 0) << file;
  return status.st_mode & 0777U;
}

TEST(CacheFolder, IsMadeForThisUserAlone) {
  const ScratchFolder files;
  const fs::path folder = files.path() / "new" / "cache";
  const CacheStore cache(folder);
  ASSERT_TRUE(cache.store("compile", folder_key, "one"));
  for (const fs::path& made : {files.path() / "new", folder, cache.file("compile", folder_key).parent_path()})
    EXPECT_EQ(mode_of(made), 0700U) << made;
}

TEST(CacheFolder, ThatOthersCanWriteToKeepsNothing) {
  const ScratchFolder files;
  ASSERT_TRUE(CacheStore(files.path()).store("compile", folder_key, "one"));
  for (const fs::perms who : {fs::perms::group_write, fs::perms::others_write}) {
    fs::permissions(files.path(), fs::perms::owner_all | who);
    const CacheStore cache(files.path());
    EXPECT_EQ(cache.find("compile", folder_key), std::nullopt);
    EXPECT_FALSE(cache.store("compile", folder_key, "two"));
    EXPECT_THAT(cache_folder_problem(files.path()), HasSubstr("others can write to"));
  }
  fs::permissions(files.path(), fs::perms::owner_all | fs::perms::group_read | fs::perms::others_read);
  const fs::path entries = CacheStore(files.path()).file("compile", folder_key).parent_path();
  fs::permissions(entries, fs::perms::all);
  EXPECT_EQ(CacheStore(files.path()).find("compile", folder_key), std::nullopt) << "where the entry lies";
  fs::permissions(entries, fs::perms::owner_all);
  EXPECT_EQ(CacheStore(files.path()).find("compile", folder_key), "one");
}

// The superuser can give a folder away; others look at one that is the superuser's.
TEST(CacheFolder, OfAnotherUserKeepsNothing) {
  const ScratchFolder files;
  fs::path folder = "/";
  if (::geteuid() == 0) {
    folder = files.path() / "given";
    ASSERT_TRUE(CacheStore(folder).store("compile", folder_key, "one"));
    ASSERT_EQ(::chown(folder.c_str(), 1, 1), 0);
  }
  EXPECT_THAT(cache_folder_problem(folder), HasSubstr("belongs to another user"));
  EXPECT_EQ(CacheStore(folder).find("compile", folder_key), std::nullopt);
  EXPECT_FALSE(CacheStore(folder).store("compile", folder_key, "two"));
  EXPECT_FALSE(make_cache_folder(folder));
}

class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    value == nullptr ? ::unsetenv(name) : ::setenv(name, value, 1);
  }
  ~Variable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(CacheFolder, IsNowhereWithoutAHome) {
  const Variable given("PENUMBRA_CACHE", nullptr), xdg("XDG_CACHE_HOME", nullptr);
  {
    const Variable home("HOME", nullptr);
    EXPECT_EQ(cache_directory(), "");
    EXPECT_EQ(cache_directory("reference"), "");
  }
  for (const char* none : {"/nonexistent", "relative", "."}) {
    const Variable home("HOME", none);
    EXPECT_EQ(cache_directory(), "") << none;
  }
  const std::string there = std::filesystem::temp_directory_path().string();
  const Variable home("HOME", there.c_str());
  EXPECT_EQ(cache_directory("reference"), there + "/.cache/penumbra/reference");
}

}  // namespace
}  // namespace penumbra::platform
