// Compares the values that Map/ writes into filtered maps with the same values in double precision.
#include <algorithm>
#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

std::vector<float> depths_over_the_range() {
  std::vector<float> depths;
  for (int i = 0; i <= 4096; ++i) depths.push_back(static_cast<float>(i) / 4096.0f);
  return depths;
}

double centred(float stored, DepthDirection direction) {
  return direction == DepthDirection::reversed ? 0.5 - stored : stored - 0.5;
}

TEST(FourMoments, AreStoredBetweenZeroAndOneAndComeBack) {
  const CoreFunction moments = function_in("Map", "FourMoments",
                                           "float4 s = StoredMoments(In(0)); float4 m = MomentsOf(s); for "
                                           "(int i = 0; i < 4; ++i) { Out(i, s[i]); Out(4 + i, m[i]); }",
                                           1, 8);
  for (const DepthDirection direction : kDepthDirections) {
    const std::vector<float> depths = depths_over_the_range();
    const std::vector<float> out = run(moments, direction, depths);
    std::vector<float> least(4, 1.0f), most(4, 0.0f);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const double z = 2.0 * centred(depths[i], direction);
      for (std::size_t k = 0; k < 4; ++k) {
        least[k] = std::min(least[k], out[8 * i + k]);
        most[k] = std::max(most[k], out[8 * i + k]);
        ASSERT_NEAR(out[8 * i + 4 + k], std::pow(z, static_cast<double>(k + 1)), 1e-6) << depths[i];
      }
    }
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(least[k], 0.0f, 1e-6f) << "the whole range of an integer format is used: " << k;
      EXPECT_NEAR(most[k], 1.0f, 1e-6f) << k;
    }
  }
}

TEST(StoredDepthMoments, LieBetweenZeroAndOneAndComeBack) {
  const CoreFunction moments = function_in(
      "Map", "DepthMoments",
      "float2 s = StoredDepthMoments(In(0)); float2 m = DepthMomentsOf(s); Out2(0, s.xy); Out2(2, m.xy);", 1,
      4);
  for (const DepthDirection direction : kDepthDirections) {
    const std::vector<float> depths = depths_over_the_range();
    const std::vector<float> out = run(moments, direction, depths);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const double z = centred(depths[i], direction);
      ASSERT_NEAR(out[4 * i], z + 0.5, 1e-7) << depths[i];
      ASSERT_NEAR(out[4 * i + 1], 4.0 * z * z, 2e-7) << depths[i];
      ASSERT_NEAR(out[4 * i + 2], z, 1e-7) << depths[i];
      ASSERT_NEAR(out[4 * i + 3], z * z, 1e-7) << depths[i];
    }
  }
}

// A tile of 1024 texels lies at (1024, 0). In its middle the taps' distances and widths make up the deviation
// that was asked for; at its border no tap reads beyond, in the coarser of two levels.
TEST(TapsOf, HaveTheDeviationAndStayInTheTile) {
  const CoreFunction taps =
      function_in("Map", "MapLevels",
                  "TileBounds b; b.minimum = float2(1024.0, 0.0); b.maximum = float2(2048.0, 1024.0); "
                  "LevelTaps t = TapsOf(In2(0), In(2), b); Out(0, t.level); for (int i = 0; i < 4; ++i) { "
                  "Out(1 + 2 * i, t.at[i].x); Out(2 + 2 * i, t.at[i].y); }",
                  3, 9);
  Random random(52);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    const bool middle = i % 2 == 0;
    inputs.push_back(middle ? 1536.0f : random.between(1024.0f, 2048.0f));
    inputs.push_back(middle ? 512.0f : random.between(0.0f, 1024.0f));
    inputs.push_back(middle ? random.between(0.6f, 200.0f) : random.between(0.1f, 2000.0f));
  }
  const std::vector<float> out = run(taps, inputs);
  for (std::size_t i = 0; i < std::size_t(kRandomCases); ++i) {
    const float* found = &out[9 * i];
    const double deviation = inputs[3 * i + 2], reach = 0.5 * std::exp2(std::ceil(found[0]));
    double squares = 0.0;
    for (int tap = 0; tap < 4; ++tap) {
      const double x = found[1 + 2 * tap], y = found[2 + 2 * tap];
      squares += 0.125 * ((x - 1536.0) * (x - 1536.0) + (y - 512.0) * (y - 512.0));
      ASSERT_TRUE(x - reach >= 1024.0 && x + reach <= 2048.0 && y - reach >= 0.0 && y + reach <= 1024.0)
          << x << ", " << y << " at level " << found[0];
    }
    if (i % 2 == 0) {
      ASSERT_NEAR((squares + 0.25 * std::exp2(2.0 * found[0])) / (deviation * deviation), 1.0, 2e-3);
    }
  }
}

// The largest exponents that DepthWarp.hlsl names fit into the numbers of both formats.
TEST(DepthWarp, ItsLargestExponentsFitTheirFormats) {
  const CoreFunction warp =
      function_in("Map", "DepthWarp",
                  "float4 m = WarpedMoments(In(0), float2(In(1), In(1))); Out(0, ExponentialOfDepth(In(0), "
                  "In(2))); for (int i = 0; i < 4; ++i) Out(1 + i, m[i]);",
                  3, 5);
  struct Format {
    double smallest, largest;  // normal numbers
    float squared, single;     // exponents
  };
  const double float_sum = 11.0;  // weights of a blur before its division
  for (const Format& format : {Format{std::ldexp(1.0, -126), std::ldexp(1.0, 128) / float_sum, 86.0f, 172.0f},
                               Format{std::ldexp(1.0, -14), 65504.0, 9.0f, 19.0f}}) {
    for (const float depth : {0.0f, 1.0f}) {
      for (const float value : run(warp, {depth, format.squared, format.single})) {
        EXPECT_LT(std::fabs(value), format.largest) << depth << ", " << format.single;
        EXPECT_GT(std::fabs(value), format.smallest) << depth << ", " << format.single;
      }
    }
  }
}

TEST(DepthWarp, IsTheExponentialOfTheDepth) {
  const CoreFunction warp =
      function_in("Map", "DepthWarp", "Out2(0, WarpedDepth(CentredDepth(In(0)), float2(80.0, 10.0)));", 1, 2);
  for (const DepthDirection direction : kDepthDirections) {
    const std::vector<float> depths = depths_over_the_range();
    const std::vector<float> out = run(warp, direction, depths);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const double z = centred(depths[i], direction);
      ASSERT_NEAR(out[2 * i] / std::exp(80.0 * z), 1.0, 1e-5) << depths[i];
      ASSERT_NEAR(out[2 * i + 1] / -std::exp(-10.0 * z), 1.0, 1e-5) << depths[i];
    }
  }
}

TEST(LogarithmicSum, IsTheLogarithmOfTheSumWithoutOverflow) {
  const CoreFunction sum =
      function_in("Map", "LogarithmicSum",
                  "LogarithmicSum s = EmptyLogarithmicSum(); for (uint i = 0; i < 4; ++i) s = AddTerm(s, "
                  "In(2 * i), In(2 * i + 1)); Out(0, LogarithmOf(s));",
                  8, 1);
  Random random(51);
  std::vector<float> inputs;
  std::vector<double> exact;
  for (int i = 0; i < kRandomCases; ++i) {
    const float spread = i % 2 == 0 ? 5.0f : 1000.0f;
    long double largest = -1e30L, total = 0.0L;
    const std::size_t first = inputs.size();
    for (int term = 0; term < 4; ++term) {
      inputs.push_back(random.between(-spread, spread));
      inputs.push_back(random.between(0.01f, 1.0f));
      largest = std::max(largest, static_cast<long double>(inputs[inputs.size() - 2]));
    }
    for (std::size_t at = first; at < inputs.size(); at += 2)
      total += inputs[at + 1] * std::exp(static_cast<long double>(inputs[at]) - largest);
    exact.push_back(static_cast<double>(largest + std::log(total)));
  }
  const std::vector<float> sums = run(sum, inputs);
  // A float near 1000 has a spacing of 6e-5, and the exponentials' arguments have that error.
  for (std::size_t i = 0; i < exact.size(); ++i)
    ASSERT_NEAR(sums[i], exact[i], i % 2 == 0 ? 3e-6 : 2e-4) << i;
}

}  // namespace
}  // namespace penumbra::shader_library_tests
