// The commit that results name covers the shaders, which are read long after the program was built.
#include "platform/source_commit.h"

#include <gtest/gtest.h>

#include <fstream>

#include "platform/child_process.h"

namespace penumbra::platform {
namespace {

class SourceCommit : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("source_commit_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "ShaderLibrary");
    write("ShaderLibrary/Filter.hlsl", "float Filter() { return 1.0; }\n");
    write("README.md", "before\n");
    git({"init", "--quiet"});
    git({"add", "."});
    git({"-c", "user.name=Somebody", "-c", "user.email=somebody@example.org", "commit", "--quiet", "-m",
         "All"});
    commit_ = git({"rev-parse", "HEAD"}).substr(0, 40);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  std::string git(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"-C", folder_.string()});
    const ChildResult result = run_child({"git", arguments, ""});
    EXPECT_TRUE(result.succeeded()) << result.errors;
    return result.output;
  }

  std::filesystem::path folder_;
  std::string commit_;
};

TEST_F(SourceCommit, IsTheBuildsWhileTheShadersAreThose) {
  EXPECT_EQ(source_commit_in(commit_, folder_), commit_);
  write("README.md", "after\n");
  EXPECT_EQ(source_commit_in(commit_, folder_), commit_) << "no page changes a result";
}

TEST_F(SourceCommit, IsDirtyOnceAShaderChangedSinceTheBuild) {
  write("ShaderLibrary/Filter.hlsl", "float Filter() { return 0.5; }\n");
  EXPECT_EQ(source_commit_in(commit_, folder_), commit_ + "-dirty");
  git({"-c", "user.name=Somebody", "-c", "user.email=somebody@example.org", "commit", "--quiet", "-a", "-m",
       "Half"});
  EXPECT_EQ(source_commit_in(commit_, folder_), commit_ + "-dirty") << "committed, but the program is older";
}

TEST_F(SourceCommit, StaysWhatTheBuildSaidWhereNothingTells) {
  EXPECT_EQ(source_commit_in("", folder_), std::nullopt);
  EXPECT_EQ(source_commit_in(commit_ + "-dirty", folder_), commit_ + "-dirty");
  EXPECT_EQ(source_commit_in(commit_, folder_ / "ShaderLibrary"), commit_)
      << "an installed copy is no checkout";
}

}  // namespace
}  // namespace penumbra::platform
