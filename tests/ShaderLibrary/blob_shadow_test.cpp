// Core/BlobShadow.hlsl against the sphere's own shadow and the rule of what receives it.
#include <gtest/gtest.h>

#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

// The inputs are the normal's y, the ball, the direction towards the sun, half its diameter, and the fade;
// the receiver is the origin.
const CoreFunction kBlob{"BlobShadow",
                         "const float4 ball = In4(1), sun = In4(5); const float3 at = float3(0.0, 0.0, 0.0); "
                         "Out(0, BlobVisibility(at, float3(0.0, In(0), 0.0), ball, sun, In(9))); Out(1, "
                         "SphereVisibility(at, ball.xyz, ball.w, sun.xyz, sun.w));",
                         10, 2};

TEST(BlobVisibility, IsTheSpheresFadedWithTheHeightOfItsLowestPoint) {
  const std::vector<float> cases = random_cases(81, [&](Random& random, int i) {
    const float elevation = random.between(0.2f, 1.5f), distance = random.between(0.5f, 6.0f);
    const float radius = random.between(0.1f, 1.0f);
    return Case{random.between(0.0f, 1.0f) < 0.5f ? 1.0f : -0.8f,
                distance * std::cos(elevation) + random.between(-0.5f, 0.5f),
                distance * std::sin(elevation),
                random.between(-0.5f, 0.5f),
                radius,
                std::cos(elevation),
                std::sin(elevation),
                0.0f,
                random.between(0.002f, 0.05f),
                i % 3 == 0 ? 0.0f : random.between(0.2f, 8.0f)};
  });
  const std::vector<float> seen = run(kBlob, cases);
  int faded = 0;
  for (std::size_t i = 0; i < seen.size() / 2; ++i) {
    const float* in = &cases[10 * i];
    const double height = std::max(static_cast<double>(in[2]) - static_cast<double>(in[4]), 0.0);
    const double strength = in[9] > 0.0f ? 1.0 - std::min(height / static_cast<double>(in[9]), 1.0) : 1.0;
    ASSERT_NEAR(seen[2 * i], 1.0 - strength * (1.0 - static_cast<double>(seen[2 * i + 1])), 1e-6) << i;
    faded += strength > 0.0 && strength < 1.0 && seen[2 * i + 1] < 1.0f ? 1 : 0;
  }
  EXPECT_GT(faded, 1000);
}

TEST(BlobVisibility, FallsOnWhatLiesUnderTheBallAndFacesUpOrDown) {
  const auto seen = [](float normal, float height) {
    return run(kBlob, {normal, 0.0f, height, 0.0f, 0.5f, 0.0f, 1.0f, 0.0f, 0.005f, 0.0f})[0];
  };
  EXPECT_EQ(seen(1.0f, 2.0f), 0.0f);
  EXPECT_EQ(seen(-1.0f, 2.0f), 0.0f);
  EXPECT_EQ(seen(1.0f, 0.25f), 0.0f) << "within the ball, below its middle";
  EXPECT_EQ(seen(1.0f, -0.25f), 1.0f) << "within the ball, above its middle";
  EXPECT_EQ(seen(0.51f, 2.0f), 0.0f);
  EXPECT_EQ(seen(0.5f, 2.0f), 1.0f) << "a wall";
  EXPECT_EQ(seen(0.0f, 2.0f), 1.0f) << "no normal";
}

TEST(BlobVisibility, StaysInRangeForAnyNumbers) {
  Random random(82);
  const std::vector<float> seen = run(kBlob, random_special_floats(random, 10 * kRandomCases));
  for (std::size_t i = 0; i < seen.size(); i += 2) ASSERT_TRUE(seen[i] >= 0.0f && seen[i] <= 1.0f) << i;
}

}  // namespace
}  // namespace penumbra::shader_library_tests
