#include "input/nearest_name.h"

#include <gmock/gmock.h>

namespace penumbra {
namespace {

using testing::HasSubstr;

const std::vector<std::string> kKeys{"distance_metres", "cascades", "resolution", "depth_bias"};

TEST(NearestName, FindsOneTypingError) {
  EXPECT_EQ(nearest_name("cascade", kKeys), "cascades");
  EXPECT_EQ(nearest_name("resoltuion", kKeys), "resolution");  // neighbours swapped: one edit
  EXPECT_EQ(nearest_name("Depth_Bias", kKeys), "depth_bias");  // case does not count
}

TEST(NearestName, SwappedNeighboursAreOneEditNotTwo) {
  EXPECT_EQ(nearest_name("abdc", {"abef", "abcd"}), "abcd");
}

TEST(NearestName, FindsTheNameThatTheGivenOneIsAPartOf) {
  const std::vector<std::string> camera{"position", "forward", "up", "fov_y_degrees", "near", "far"};
  EXPECT_EQ(nearest_name("fov", camera), "fov_y_degrees");  // "far" is two edits away
  EXPECT_EQ(nearest_name("y_deg", camera), "fov_y_degrees");
  EXPECT_EQ(nearest_name("FAR", camera), "far");
  EXPECT_EQ(nearest_name("tent", {"tent-5-plane", "tent-5", "hard"}), "tent-5");
  EXPECT_EQ(nearest_name("ard", {"forward"}), "") << "not the beginning of a word";
}

TEST(NearestName, SaysNothingWhenNothingIsNear) {
  EXPECT_EQ(nearest_name("banana", kKeys), "");
  EXPECT_EQ(nearest_name("x", {}), "");
}

TEST(NearestName, RemedyNamesTheNearestOrAll) {
  EXPECT_EQ(unknown_name_remedy("cascads", kKeys), "did you mean 'cascades'?");
  for (const std::string& key : kKeys) EXPECT_THAT(unknown_name_remedy("banana", kKeys), HasSubstr(key));
}

TEST(NearestName, NothingIsNearAWordOfMegabytes) {
  const std::string word(2'000'000, 'a');
  EXPECT_EQ(nearest_name(word, {"a", word + "b", std::string(1'999'999, 'a')}), "");
  EXPECT_EQ(nearest_name("fov", {word, "fog"}), "fog");
}

TEST(NearestName, TheListOfKnownNamesIsBounded) {
  std::vector<std::string> known;
  for (int i = 0; i < 100000; ++i) known.push_back("name" + std::to_string(i));
  const std::string remedy = unknown_name_remedy("zzzzzzzzzz", known);
  EXPECT_TRUE(remedy.ends_with(" name59 and 99940 more")) << remedy;
}

}  // namespace
}  // namespace penumbra
