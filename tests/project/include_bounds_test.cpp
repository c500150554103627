// Tests what a file belongs to, and what is outside of it.
#include "project/include_bounds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "platform/cache_store.h"
#include "project_folder.h"

namespace penumbra::project {
namespace {

namespace fs = std::filesystem;

TEST(OwnTree, IsTheRepositoryElseTheProjectElseThePackageElseTheFolder) {
  const ProjectFolder files;
  const fs::path shader = files.write("a/b/c/d/Main.shader", "");
  EXPECT_EQ(own_tree(shader), files.path("a/b/c/d"));
  files.package("a/b/c", "com.x.core", "1.0.0");
  EXPECT_EQ(own_tree(shader), files.path("a/b/c"));
  fs::create_directories(files.path("a/b/Assets"));
  EXPECT_EQ(own_tree(shader), files.path("a/b/c")) << "Assets/ alone makes no project";
  fs::create_directories(files.path("a/b/ProjectSettings"));
  EXPECT_EQ(own_tree(shader), files.path("a/b"));
  files.write("a/.git", "gitdir: elsewhere");
  EXPECT_EQ(own_tree(shader), files.path("a"));
}

class HomeFolder : public testing::Test {
 protected:
  void TearDown() override { be_home(before_); }
  static void be_home(const std::string& folder) { ::setenv("HOME", folder.c_str(), 1); }

  ProjectFolder files;

 private:
  std::string before_ = std::getenv("HOME") == nullptr ? "" : std::getenv("HOME");
};

TEST_F(HomeFolder, IsNoTreeHoweverItIsSpelt) {
  const fs::path shader = files.write("home/own/Main.shader", "");
  const fs::path beside = files.write("home/Main.shader", "");
  fs::create_directories(files.path("home/.git"));
  fs::create_directory_symlink(files.path("home"), files.path("link"));
  EXPECT_EQ(own_tree(shader), files.path("home"));
  for (const std::string& home :
       {files.text("home"), files.text("home") + "/", files.text("home/own/.."), files.text("link")}) {
    be_home(home);
    EXPECT_EQ(own_tree(shader), files.path("home/own")) << home;
    EXPECT_EQ(own_tree(beside), beside) << home << ": the file alone";
    EXPECT_TRUE(no_file_owns(files.path("home"))) << home;
    EXPECT_FALSE(no_file_owns(files.path("home/own"))) << home;
  }
}

// A service has no HOME, or somebody else's.
TEST_F(HomeFolder, IsAlsoTheOneThatTheSystemLists) {
  const fs::path listed = platform::listed_home();
  if (listed.empty()) GTEST_SKIP() << "the system does not list this user";
  const fs::path file = listed / "Main.shader";
  for (const char* home : {"", "relative", "/elsewhere"}) {
    be_home(home);
    EXPECT_TRUE(no_file_owns(listed)) << home;
    EXPECT_EQ(own_tree(file), file) << home;
  }
}

TEST_F(HomeFolder, NorIsTheDisksRoot) {
  EXPECT_EQ(own_tree("/Main.shader"), "/Main.shader");
  EXPECT_TRUE(no_file_owns("/"));
  be_home("");
  EXPECT_FALSE(no_file_owns(fs::current_path())) << "no home is not the current folder";
}

class IncludeBoundsTest : public testing::Test {
 protected:
  IncludeBoundsTest() {
    files.write("in/a.hlsl", "");
    files.write("inner/b.hlsl", "");
    bounds.add(files.path("in"));
  }

  bool contain(const std::string& name) const { return bounds.contain(files.path(name)); }

  ProjectFolder files;
  IncludeBounds bounds;
};

TEST_F(IncludeBoundsTest, HoldWhatIsBelowARoot) {
  EXPECT_TRUE(contain("in/a.hlsl"));
  EXPECT_TRUE(contain("in/not/there.hlsl"));
  EXPECT_TRUE(contain("inner/../in/a.hlsl"));
  EXPECT_FALSE(contain("inner/b.hlsl")) << "a name that only begins as a root's does";
  EXPECT_FALSE(contain("in/../inner/b.hlsl"));
  EXPECT_FALSE(contain("in/not/there/../../../inner/b.hlsl"));
  EXPECT_FALSE(bounds.contain("/etc/passwd"));
  EXPECT_FALSE(IncludeBounds().contain(files.path("in/a.hlsl")));
}

TEST_F(IncludeBoundsTest, FollowLinks) {
  fs::create_symlink(files.path("inner/b.hlsl"), files.path("in/file.hlsl"));
  fs::create_directory_symlink(files.path("inner"), files.path("in/folder"));
  fs::create_symlink(files.path("in/file.hlsl"), files.path("in/twice.hlsl"));
  EXPECT_FALSE(contain("in/file.hlsl"));
  EXPECT_FALSE(contain("in/twice.hlsl"));
  EXPECT_FALSE(contain("in/folder/b.hlsl"));
  fs::create_directory_symlink(files.path("in"), files.path("link_to_in"));
  EXPECT_TRUE(contain("link_to_in/a.hlsl"));
  bounds.add(files.path("in/folder"));
  EXPECT_TRUE(contain("inner/b.hlsl")) << "a root may be a link itself";
}

TEST_F(IncludeBoundsTest, AFileStandsForItself) {
  bounds.add(files.path("inner/b.hlsl"));
  EXPECT_TRUE(contain("inner/b.hlsl"));
  EXPECT_FALSE(contain("inner/c.hlsl"));
}

TEST_F(IncludeBoundsTest, LeaveOutWhatGitKeeps) {
  files.write("in/.git/config", "");
  EXPECT_FALSE(contain("in/.git/config"));
  fs::create_directory_symlink(files.path("in/.git"), files.path("in/Shaders"));
  EXPECT_FALSE(contain("in/Shaders/config"));
}

}  // namespace
}  // namespace penumbra::project
