// Core/FarHandOver.hlsl against the cubic in long double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

// The inputs are distance, shadow distance and border, then both visibilities.
const CoreFunction kHandOver{"FarHandOver",
                             "const float share = FarShare(In(0), In(1), In(2)); Out(0, share); Out(1, "
                             "HandedOver(In(3), In(4), share));",
                             5, 2};

long double share_at(float distance, float shadow_distance, float border) {
  const long double width = std::max(static_cast<long double>(shadow_distance) * border, 1e-6L);
  const long double t =
      1.0L - std::clamp((static_cast<long double>(shadow_distance) - distance) / width, 0.0L, 1.0L);
  return t * t * (3.0L - 2.0L * t);
}

TEST(FarShare, RisesFromTheBorderToTheShadowDistance) {
  const std::vector<float> cases = random_cases(81, [&](Random& random) {
    return Case{random.between(0.0f, 400.0f), random.between(10.0f, 300.0f), random.between(0.05f, 1.0f),
                random.between(0.0f, 1.0f), random.between(0.0f, 1.0f)};
  });
  const std::vector<float> seen = run(kHandOver, cases);
  int before = 0, within = 0, beyond = 0;
  for (std::size_t i = 0; i < seen.size() / 2; ++i) {
    const float* in = &cases[5 * i];
    const auto share = static_cast<double>(share_at(in[0], in[1], in[2]));
    ASSERT_NEAR(seen[2 * i], share, 2e-5) << i;
    const double mixed = in[3] + share * (static_cast<double>(in[4]) - static_cast<double>(in[3]));
    ASSERT_NEAR(seen[2 * i + 1], mixed, 3e-5) << i;
    if (in[0] <= in[1] * (1.0f - in[2]) * 0.999f) {
      ASSERT_EQ(seen[2 * i], 0.0f) << i;
      ASSERT_EQ(seen[2 * i + 1], in[3]) << i;
      ++before;
    } else if (in[0] >= in[1]) {
      ASSERT_EQ(seen[2 * i], 1.0f) << i;
      ++beyond;
    } else {
      ++within;
    }
  }
  EXPECT_GT(before, 1000);
  EXPECT_GT(within, 1000);
  EXPECT_GT(beyond, 1000);
}

TEST(FarShare, StaysInRangeAndWhatIsNoDistanceIsFar) {
  Random random(82);
  const std::vector<float> cases = random_special_floats(random, 5 * kRandomCases);
  const std::vector<float> seen = run(kHandOver, cases);
  for (std::size_t i = 0; i < seen.size() / 2; ++i) {
    ASSERT_TRUE(seen[2 * i] >= 0.0f && seen[2 * i] <= 1.0f) << i;
    if (!std::isnan(cases[5 * i])) continue;
    ASSERT_EQ(seen[2 * i], 1.0f) << i;
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
