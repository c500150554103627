// Tests patterns over paths, one meaning at a time, and against a plain recursive reading of the same rules.
#include "project/shader_files.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace penumbra::project {
namespace {

TEST(PathPattern, StarStaysInAFolder) {
  EXPECT_TRUE(path_matches("Assets/*.shader", "Assets/Water.shader"));
  EXPECT_FALSE(path_matches("Assets/*.shader", "Assets/Sea/Water.shader"));
  EXPECT_TRUE(path_matches("Assets/?ea/*", "Assets/Sea/Water.shader"));
  EXPECT_FALSE(path_matches("Assets?Sea", "Assets/Sea"));
}

TEST(PathPattern, TwoStarsCrossFolders) {
  EXPECT_TRUE(path_matches("Assets/Water/**", "Assets/Water/a/b/c.shader"));
  EXPECT_TRUE(path_matches("Assets/Water/**", "Assets/Water/c.shader"));
  EXPECT_FALSE(path_matches("Assets/Water/**", "Assets/Waterfall/c.shader"));
  EXPECT_FALSE(path_matches("Assets/Water/**", "Assets/Water"));
}

TEST(PathPattern, TwoStarsBetweenSlashesAreAnyFoldersOrNone) {
  EXPECT_TRUE(path_matches("Assets/**/a.shader", "Assets/a.shader"));
  EXPECT_TRUE(path_matches("Assets/**/a.shader", "Assets/x/y/a.shader"));
  EXPECT_FALSE(path_matches("Assets/**/a.shader", "Assets/x/ba.shader"));
  EXPECT_TRUE(path_matches("**/**/a.shader", "a.shader"));
}

TEST(PathPattern, PatternWithoutSlashIsAboutTheName) {
  EXPECT_TRUE(path_matches("*.compute", "Assets/x/y.compute"));
  EXPECT_FALSE(path_matches("x", "Assets/x/y.compute"));
  EXPECT_TRUE(path_matches("y.compute", "y.compute"));
}

TEST(PathPattern, EverythingElseStandsForItself) {
  EXPECT_TRUE(path_matches("Assets/[a]{b}.shader", "Assets/[a]{b}.shader"));
  EXPECT_FALSE(path_matches("assets/a", "Assets/a"));
  EXPECT_FALSE(path_matches("", "a"));
}

// The rules of the header are read one by one with backtracking.
bool matches_slowly(std::string_view pattern, std::string_view path, bool at_start = true) {
  if (pattern.empty()) return path.empty();
  if (at_start && pattern.substr(0, 3) == "**/") {
    if (matches_slowly(pattern.substr(3), path)) return true;
    for (std::size_t i = 0; i < path.size(); ++i)
      if (path[i] == '/' && matches_slowly(pattern.substr(3), path.substr(i + 1))) return true;
    return false;
  }
  const bool two = pattern.substr(0, 2) == "**";
  if (pattern[0] == '*') {
    const std::string_view rest = pattern.substr(two ? 2 : 1);
    for (std::size_t i = 0;; ++i) {
      if (matches_slowly(rest, path.substr(i), false)) return true;
      if (i == path.size() || (!two && path[i] == '/')) return false;
    }
  }
  if (path.empty() || (pattern[0] == '?' ? path[0] == '/' : path[0] != pattern[0])) return false;
  return matches_slowly(pattern.substr(1), path.substr(1), pattern[0] == '/');
}

TEST(PathPattern, AgreesWithAPlainReadingOfTheRules) {
  std::mt19937 random(7);
  const std::string pattern_letters = "ab/**?";
  const std::string path_letters = "ab/";
  int matched = 0;
  for (int i = 0; i < 200000; ++i) {
    std::string pattern = "/";  // a slash is there so that whole paths are compared
    std::string path = "/";
    for (std::size_t n = random() % 7; n > 0; --n)
      pattern += pattern_letters[random() % pattern_letters.size()];
    for (std::size_t n = random() % 7; n > 0; --n) path += path_letters[random() % path_letters.size()];
    const bool expected = matches_slowly(pattern, path);
    ASSERT_EQ(path_matches(pattern, path), expected) << pattern << " on " << path;
    matched += expected ? 1 : 0;
  }
  EXPECT_GT(matched, 1000);  // the comparison is not of refusals alone
}

TEST(PathPattern, ManyStarsTakeNoLongerThanTheirProduct) {
  std::string pattern = "a/";
  for (int i = 0; i < 500; ++i) pattern += "*a**";
  pattern += "b";
  const std::string path = "a/" + std::string(5000, 'a');
  EXPECT_FALSE(path_matches(pattern, path));  // backtracking would not end
}

}  // namespace
}  // namespace penumbra::project
