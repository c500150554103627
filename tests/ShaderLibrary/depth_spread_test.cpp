// Map/DepthSpread.hlsl: mean and standard deviation of texels and of cells against sums in long double, and
// what 16 bits keep of them.
#include <gtest/gtest.h>

#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

CoreFunction depth_spread(const std::string& statement, int inputs, int outputs) {
  return function_in("Map", "DepthSpread", statement, inputs, outputs);
}

struct ExactSpread {
  long double mean = 0.0L;
  long double deviation = 0.0L;
};

ExactSpread exact_spread(const float* depths, std::size_t count) {
  ExactSpread spread;
  for (std::size_t i = 0; i < count; ++i) spread.mean += depths[i];
  spread.mean /= static_cast<long double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const long double away = depths[i] - spread.mean;
    spread.deviation += away * away;
  }
  spread.deviation = std::sqrt(spread.deviation / static_cast<long double>(count));
  return spread;
}

// The cells are of 16 depths each: anywhere, close together, of two surfaces, all equal, and at the ends of
// the range.
std::vector<float> cells_of_texels() {
  Random random(83);
  std::vector<float> depths;
  for (int i = 0; i < kRandomCases; ++i) {
    const float near_to = random.between(0.0f, 1.0f);
    const float other = random.between(0.0f, 1.0f);
    const float width = std::exp2(random.between(-24.0f, -1.0f));
    for (int k = 0; k < 16; ++k) {
      const float any = random.between(0.0f, 1.0f);
      float depth = any;
      if (i % 5 == 1) depth = std::fmin(near_to + width * any, 1.0f);
      if (i % 5 == 2) depth = any < 0.3f ? near_to : other;
      if (i % 5 == 3) depth = near_to;
      if (i % 5 == 4) depth = any < 0.5f ? 0.0f : any < 0.9f ? 1.0f : 1e-42f;
      depths.push_back(depth);
    }
  }
  return depths;
}

TEST(DepthSpread, OfFourTexelsAndOfFourCellsAreThoseOfAllDepths) {
  const std::vector<float> depths = cells_of_texels();
  const std::vector<float> out =
      run(depth_spread(
              "DepthSpread s[4]; for (int i = 0; i < 4; ++i) s[i] = SpreadOfFour(float4(In(4 * i), In(4 * i "
              "+ 1), In(4 * i + 2), In(4 * i + 3)));const DepthSpread whole = JoinSpreads(float4(s[0].mean, "
              "s[1].mean, s[2].mean, s[3].mean), float4(s[0].deviation, s[1].deviation, s[2].deviation, "
              "s[3].deviation));Out(0, s[0].mean); Out(1, s[0].deviation); Out(2, whole.mean); Out(3, "
              "whole.deviation);",
              16, 4),
          depths);
  for (std::size_t i = 0; i < depths.size() / 16; ++i) {
    const ExactSpread four = exact_spread(&depths[16 * i], 4);
    const ExactSpread all = exact_spread(&depths[16 * i], 16);
    ASSERT_NEAR(out[4 * i], static_cast<double>(four.mean), 2e-7) << i;
    ASSERT_NEAR(out[4 * i + 1], static_cast<double>(four.deviation), 2e-7) << i;
    ASSERT_NEAR(out[4 * i + 2], static_cast<double>(all.mean), 3e-7) << i;
    ASSERT_NEAR(out[4 * i + 3], static_cast<double>(all.deviation), 3e-7) << i;
    if (i % 5 == 3) {
      ASSERT_EQ(out[4 * i + 1], 0.0f) << i;
      ASSERT_EQ(out[4 * i + 3], 0.0f) << i;
    }
  }
}

TEST(DepthSpread, KeepsSixteenBitsOfBoth) {
  Random random(84);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    inputs.push_back(i == 0 ? 0.0f : i == 1 ? 1.0f : random.between(0.0f, 1.0f));
    inputs.push_back(i == 0 ? 0.0f : i == 1 ? 0.5f : random.between(0.0f, 0.5f));
  }
  const std::vector<float> out =
      run(depth_spread("DepthSpread s; s.mean = In(0); s.deviation = In(1); const DepthSpread kept = "
                       "UnpackSpread(PackSpread(s)); Out(0, kept.mean); Out(1, kept.deviation);",
                       2, 2),
          inputs);
  for (std::size_t i = 0; i < inputs.size() / 2; ++i) {
    ASSERT_NEAR(out[2 * i], inputs[2 * i], 1.01 / 131070.0) << i;
    ASSERT_NEAR(out[2 * i + 1], inputs[2 * i + 1], 1.01 / 262140.0) << i;
  }
  EXPECT_EQ(out[0], 0.0f);
  EXPECT_EQ(out[1], 0.0f);
  EXPECT_EQ(out[2], 1.0f);
  EXPECT_EQ(out[3], 0.5f);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
