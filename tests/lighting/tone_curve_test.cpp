#include "lighting/tone_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra::lighting {
namespace {

TEST(ToneCurve, IsMonotoneAndStaysInRange) {
  float last = -1.0F;
  for (int i = 0; i <= 20000; ++i) {
    const float light = std::pow(10.0F, float(i) / 2000.0F - 5.0F);
    const glm::vec3 shown = tone_mapped(glm::vec3(light));
    ASSERT_GE(shown.r, last - 1e-6F) << light << ", but for rounding";
    ASSERT_LE(shown.r, 1.0F);
    last = shown.r;
  }
  EXPECT_GT(last, 0.99F);
}

// Between the toe and the shoulder a colour loses the mirrored 4 % and nothing else.
TEST(ToneCurve, KeepsTheStepFromShadowToLight) {
  for (const float light : {0.1F, 0.3F, 0.5F, 0.75F}) {
    EXPECT_NEAR(tone_mapped({light, light, light}).g, light - 0.04F, 1e-6F);
  }
  const glm::vec3 green = tone_mapped({0.2F, 0.6F, 0.15F});
  EXPECT_NEAR(green.r, 0.16F, 1e-6F);
  EXPECT_NEAR(green.g, 0.56F, 1e-6F);
  EXPECT_NEAR(green.b, 0.11F, 1e-6F);
}

// The published code by hand for (2, 1, 0.5): offset 0.04, peak 1.96.
TEST(ToneCurve, BrightColoursAreThePublishedOnes) {
  const double compressed = 1.0 - 0.24 * 0.24 / (1.96 + 0.24 - 0.76);
  const double keep = 1.0 / (0.15 * (1.96 - compressed) + 1.0);
  const glm::vec3 shown = tone_mapped({2.0F, 1.0F, 0.5F});
  EXPECT_NEAR(shown.r, compressed, 1e-5);
  EXPECT_NEAR(shown.g, 0.96 * compressed / 1.96 * keep + compressed * (1.0 - keep), 1e-5);
  EXPECT_NEAR(shown.b, 0.46 * compressed / 1.96 * keep + compressed * (1.0 - keep), 1e-5);
}

TEST(ToneCurve, WhatIsNoLightIsBlackAndInfiniteLightIsWhite) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(tone_mapped(glm::vec3(-1.0F)), glm::vec3(0.0F));
  EXPECT_EQ(tone_mapped(glm::vec3(std::nanf(""))), glm::vec3(0.0F));
  EXPECT_GT(tone_mapped(glm::vec3(kInfinity)).r, 0.999F);
}

TEST(Srgb, EncodingComesBackAndHasItsFixedPoints) {
  for (int i = 0; i <= 255; ++i) {
    const float encoded = float(i) / 255.0F;
    EXPECT_NEAR(srgb_encoded(srgb_decoded(encoded)), encoded, 1e-5F);
  }
  EXPECT_NEAR(srgb_encoded(0.18F) * 255.0F, 117.6F, 0.5F);
  EXPECT_EQ(srgb_encoded(7.0F), srgb_encoded(1.0F));
}

}  // namespace
}  // namespace penumbra::lighting
