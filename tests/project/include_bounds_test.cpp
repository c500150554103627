// What a file belongs to, and what is outside of it.
#include "project/include_bounds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

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

TEST(OwnTree, IsNeverTheHomeFolder) {
  const ProjectFolder files;
  const fs::path shader = files.write("home/work/Main.shader", "");
  fs::create_directories(files.path("home/.git"));
  EXPECT_EQ(own_tree(shader), files.path("home"));
  const std::string before = std::getenv("HOME") == nullptr ? "" : std::getenv("HOME");
  ::setenv("HOME", files.text("home").c_str(), 1);
  EXPECT_EQ(own_tree(shader), files.path("home/work"));
  ::setenv("HOME", before.c_str(), 1);
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
