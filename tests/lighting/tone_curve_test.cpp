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

TEST(ToneCurve, IsStraightInTheMiddle) {
  EXPECT_EQ(tone_mapped({0.22F, 0.4F, 0.53F}), glm::vec3(0.22F, 0.4F, 0.53F));
}

TEST(ToneCurve, ItsToeIsThePublishedOne) {
  for (const double light : {0.001, 0.05, 0.1, 0.2}) {
    const double share = light / 0.22;
    const double straight = share * share * (3.0 - 2.0 * share);  // smoothstep
    const double expected = (1.0 - straight) * 0.22 * std::pow(share, 1.33) + straight * light;
    EXPECT_NEAR(tone_mapped(glm::vec3(float(light))).g, expected, 1e-6) << light;
  }
}

// The published formula is worked out by hand: S1 = m + l0 = 0.532, C2 = aP / (P - S1), S = P - (P - S1)
// exp(-C2 (x - S0) / P).
TEST(ToneCurve, ItsShoulderIsThePublishedOne) {
  const double l0 = (1.0 - 0.22) * 0.4;
  const double s1 = 0.22 + l0;
  for (const double light : {0.6, 1.0, 2.5}) {
    const double expected = 1.0 - (1.0 - s1) * std::exp(-1.0 / (1.0 - s1) * (light - s1));
    EXPECT_NEAR(tone_mapped(glm::vec3(float(light))).g, expected, 1e-6) << light;
  }
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
