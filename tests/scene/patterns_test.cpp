#include "scene/patterns.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace penumbra::scene {
namespace {

const Grain kGrain{.cells_x = 4, .cells_y = 4, .octaves = 4, .persistence = 0.5, .seed = 7};

TEST(Patterns, ReliefFillsItsRangeAndRepeatsWithoutASeam) {
  const Relief relief = fractal_relief(128, kGrain);
  const auto [low, high] = std::minmax_element(relief.heights.begin(), relief.heights.end());
  EXPECT_EQ(*low, 0.0);
  EXPECT_EQ(*high, 1.0);
  double inside = 0.0, seam = 0.0;  // the largest step between neighbours
  for (int y = 0; y < 128; ++y) {
    for (int x = 1; x < 128; ++x) inside = std::max(inside, std::abs(relief.at(x, y) - relief.at(x - 1, y)));
    seam = std::max(
        {seam, std::abs(relief.at(0, y) - relief.at(127, y)), std::abs(relief.at(y, 0) - relief.at(y, 127))});
  }
  EXPECT_LE(seam, 1.2 * inside);
  EXPECT_EQ(relief.at(-1, 130), relief.at(127, 2));
}

TEST(Patterns, AnotherSeedGivesAnotherRelief) {
  Grain other = kGrain;
  other.seed = 8;
  EXPECT_EQ(fractal_relief(32, kGrain).heights, fractal_relief(32, kGrain).heights);
  EXPECT_NE(fractal_relief(32, kGrain).heights, fractal_relief(32, other).heights);
}

TEST(Patterns, TintedGoesFromDarkToLightInSrgb) {
  const Texture texture =
      tinted({2, {0.0, 1.0, 0.5, 0.0}}, glm::vec3(0.0F), glm::vec3(1.0F, 0.2158605F, 0.0F));
  ASSERT_EQ(texture.rgba.size(), 16U);
  EXPECT_EQ(std::vector<int>(texture.rgba.begin(), texture.rgba.begin() + 8),
            (std::vector<int>{0, 0, 0, 255, 255, 128, 0, 255}));  // 0.2158605 is sRGB's 128
}

// The ramp rises to the right and, in rows that go down, to the bottom, so the normal leans left and up.
TEST(Patterns, NormalsLeanAgainstTheRise) {
  Relief ramp{8, {}};
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) ramp.heights.push_back((x + 0.5 * y) / 8.0);
  }
  const Texture normals = normals_of(ramp, 0.25);
  const std::uint8_t* texel = normals.rgba.data() + 4 * (3 * 8 + 3);
  const glm::dvec3 normal = glm::dvec3(texel[0], texel[1], texel[2]) / 127.5 - 1.0;
  const glm::dvec3 expected = glm::normalize(glm::dvec3(-0.25, 0.125, 1.0));
  EXPECT_LT(glm::distance(normal, expected), 0.02);
}

}  // namespace
}  // namespace penumbra::scene
