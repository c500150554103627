// The order of versions, compared with the list in Semantic Versioning 2.0.0, section 11.
#include "project/package_version.h"

#include <gtest/gtest.h>

namespace penumbra::project {
namespace {

TEST(PackageVersion, OrderIsThatOfSemanticVersioning) {
  const char* const ascending[] = {"1.0.0-alpha", "1.0.0-alpha.1", "1.0.0-alpha.beta",
                                   "1.0.0-beta",  "1.0.0-beta.2",  "1.0.0-beta.11",
                                   "1.0.0-rc.1",  "1.0.0",         "1.0.9",
                                   "1.0.10",      "1.2.0",         "10.0.0"};
  for (std::size_t i = 0; i < std::size(ascending); ++i) {
    for (std::size_t j = 0; j < std::size(ascending); ++j) {
      const auto a = parse_package_version(ascending[i]);
      const auto b = parse_package_version(ascending[j]);
      ASSERT_TRUE(a && b);
      EXPECT_EQ(*a <=> *b, i <=> j) << ascending[i] << " and " << ascending[j];
    }
  }
}

TEST(PackageVersion, BuildDataCountsForNothing) {
  EXPECT_EQ(*parse_package_version("1.2.3+a.b"), *parse_package_version("1.2.3"));
  EXPECT_EQ(*parse_package_version("1.2.3-pre.1+x"), *parse_package_version("1.2.3-pre.01"));
}

TEST(PackageVersion, SameReleaseIgnoresThePrerelease) {
  EXPECT_TRUE(parse_package_version("9.0.0-preview.13")->same_release_as(*parse_package_version("9.0.0")));
  EXPECT_FALSE(parse_package_version("14.0.9")->same_release_as(*parse_package_version("14.0.11")));
}

TEST(PackageVersion, OtherTextIsNone) {
  for (const char* text : {"", "1", "1.2", "1.2.", "1.2.x", "v1.2.3", "1.2.3-", "1.2.3x", "1.2.3-a b",
                           "file:../x", "https://host/x.git#1.2.3", "9999999999.0.0"})
    EXPECT_FALSE(parse_package_version(text).has_value()) << text;
}

}  // namespace
}  // namespace penumbra::project
