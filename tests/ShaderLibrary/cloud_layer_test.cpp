// Core/CloudLayer.hlsl against the ray's meeting with the plane in long double.
#include <gtest/gtest.h>

#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

// The inputs are area, height and border, the receiver, and the direction towards the sun.
const CoreFunction kClouds{"CloudLayer",
                           "const CloudLayer layer = BoundedCloudLayer(In4(0), In(4), In(5)); const float3 "
                           "at = In3(6); const float3 sun = In3(9); Out2(0, CloudUv(at, sun, layer)); Out(2, "
                           "CloudWeight(at, sun, layer)); Out(3, WayToLayer(at, sun, layer));",
                           12, 4};

TEST(CloudUv, IsWhereTheRayToTheSunMeetsTheLayer) {
  const std::vector<float> cases = random_cases(61, [&](Random& random) {
    return Case{random.between(-9000.0f, 0.0f), random.between(-9000.0f, 0.0f), random.between(8e3f, 2e4f),
                random.between(8e3f, 2e4f),     random.between(800.0f, 2e3f),   random.between(0.0f, 0.3f),
                random.between(-5e3f, 5e3f),    random.between(0.0f, 2500.0f),  random.between(-5e3f, 5e3f),
                random.between(-1.0f, 1.0f),    random.between(-0.2f, 1.0f),    random.between(-1.0f, 1.0f)};
  });
  const std::vector<float> seen = run(kClouds, cases);
  int faded = 0, whole = 0, none = 0;
  for (std::size_t i = 0; i < seen.size() / 4; ++i) {
    const float* in = &cases[12 * i];
    const float* out = &seen[4 * i];
    if (in[10] <= 0.0f || in[7] > in[4]) {
      ASSERT_EQ(out[2], 0.0f) << i;
      ++none;
      continue;
    }
    if (in[10] < 0.02f) continue;  // the sun is so low that digits of a float are metres
    const long double way = (static_cast<long double>(in[4]) - in[7]) / in[10];
    ASSERT_NEAR(out[3], static_cast<double>(way), 1e-5 * static_cast<double>(way) + 1e-3) << i;
    const long double u = (in[6] + way * in[9] - in[0]) / in[2], v = (in[8] + way * in[11] - in[1]) / in[3];
    ASSERT_NEAR(out[0], static_cast<double>(u), 1e-5) << i;
    ASSERT_NEAR(out[1], static_cast<double>(v), 1e-5) << i;
    const long double least = std::min(std::min(u, 1.0L - u), std::min(v, 1.0L - v));
    if (std::fabs(least) < 2e-5L) continue;
    const long double weight = least < 0.0L ? 0.0L : std::min(least / in[5], 1.0L);
    ASSERT_NEAR(out[2], static_cast<double>(weight), 1e-5 / static_cast<double>(in[5]) + 1e-5) << i;
    (weight == 1.0L ? whole : weight > 0.0L ? faded : none) += 1;
  }
  EXPECT_GT(whole, 1000);
  EXPECT_GT(faded, 1000);
  EXPECT_GT(none, 1000);
}

// The inputs are the camera, the sun, the height, the side of the map and its texels.
const CoreFunction kAround{"CloudLayer",
                           "const CloudLayer layer = CloudLayerAround(In3(0), In3(3), In(6), In(7), 0.1, "
                           "In(8)); Out2(0, layer.corner.xy); Out(2, layer.size.x); Out(3, layer.height);",
                           9, 4};

TEST(CloudLayerAround, LiesOnWholeTexelsAboutThePlaceThatShadesTheCamera) {
  const std::vector<float> cases = random_cases(63, [&](Random& random) {
    return Case{random.between(-5e3f, 5e3f),  random.between(0.0f, 500.0f), random.between(-5e3f, 5e3f),
                random.between(-0.7f, 0.7f),  random.between(0.1f, 1.0f),   random.between(-0.7f, 0.7f),
                random.between(800.0f, 2e3f), random.between(4e3f, 3e4f),   512.0f};
  });
  const std::vector<float> seen = run(kAround, cases);
  for (std::size_t i = 0; i < seen.size() / 4; ++i) {
    const float* in = &cases[9 * i];
    const float* out = &seen[4 * i];
    const double texel = static_cast<double>(in[7]) / 512.0;
    const double way = (static_cast<double>(in[6]) - static_cast<double>(in[1])) / static_cast<double>(in[4]);
    for (const int axis : {0, 1}) {
      const double centre = static_cast<double>(in[2 * axis]) + way * static_cast<double>(in[3 + 2 * axis]);
      const double corner = static_cast<double>(out[axis]);
      ASSERT_NEAR(corner / texel, std::round(corner / texel), 1e-3) << i;
      ASSERT_NEAR(corner, centre - 0.5 * static_cast<double>(in[7]) - 0.5 * texel, 0.51 * texel + 0.05) << i;
    }
    ASSERT_EQ(out[2], in[7]) << i;
    ASSERT_EQ(out[3], in[6]) << i;
  }
}

TEST(CloudLayerAround, IsFiniteForAnyNumbers) {
  Random random(64);
  const std::vector<float> cases = random_special_floats(random, 9 * kRandomCases);
  for (const float number : run(kAround, cases)) ASSERT_TRUE(std::isfinite(number));
}

TEST(CloudWeight, IsZeroForWhatIsNoPlaceOrNoSunAndFiniteForAnyNumbers) {
  Random random(62);
  const std::vector<float> cases = random_special_floats(random, 12 * kRandomCases);
  const std::vector<float> seen = run(kClouds, cases);
  for (std::size_t i = 0; i < seen.size() / 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j) ASSERT_TRUE(std::isfinite(seen[4 * i + j])) << i << " " << j;
    ASSERT_TRUE(seen[4 * i + 2] >= 0.0f && seen[4 * i + 2] <= 1.0f) << i;
    for (std::size_t j = 6; j < 12; ++j) {
      if (std::isfinite(cases[12 * i + j])) continue;
      ASSERT_EQ(seen[4 * i + 2], 0.0f) << i;
    }
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
