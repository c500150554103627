// Core/CloudCover.hlsl against the same noise in long double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

// The inputs are wind, feature size, coverage and density, then the place.
const CoreFunction kCover{
    "CloudCover",
    "const CloudCover cover = BoundedCloudCover(In2(0), In(2), In(3), In(4)); Out(0, "
    "CloudTransmittance(In2(5), cover)); Out(1, ValueNoise(In2(5) / cover.featureMetres, 3u));",
    7, 2};
const CoreFunction kLattice{"CloudCover", "Out(0, LatticeValue(int2(int(In(0)), int(In(1))), uint(In(2))));",
                            3, 1};

std::uint32_t folded(std::uint32_t bits, std::uint32_t by) {
  return bits ^ (bits >> by);
}

long double value_at(std::int64_t x, std::int64_t z, std::uint32_t octave) {
  const std::uint32_t start = static_cast<std::uint32_t>(x) * 0x8DA6B343U ^
                              static_cast<std::uint32_t>(z) * 0xD8163841U ^ octave * 0xCB1AB31FU;
  const std::uint32_t bits = folded(folded(folded(start, 15) * 0x2C1B3C6DU, 12) * 0x297A2D39U, 15);
  return static_cast<long double>(bits >> 8U) / 16777215.0L;
}

long double noise_at(long double x, long double z, std::uint32_t octave) {
  const auto column = static_cast<std::int64_t>(std::floor(x)),
             row = static_cast<std::int64_t>(std::floor(z));
  const auto fade = [](long double t) { return t * t * t * (10.0L + t * (6.0L * t - 15.0L)); };
  const long double u = fade(x - static_cast<long double>(column)),
                    v = fade(z - static_cast<long double>(row));
  return (1.0L - u) * (1.0L - v) * value_at(column, row, octave) +
         u * (1.0L - v) * value_at(column + 1, row, octave) +
         (1.0L - u) * v * value_at(column, row + 1, octave) + u * v * value_at(column + 1, row + 1, octave);
}

long double transmittance(const float* in) {
  long double sum = 0.0L;
  for (std::uint32_t octave = 0; octave < 5; ++octave) {
    const long double size = static_cast<long double>(in[2]) / static_cast<long double>(1U << octave);
    sum += 16.0L / 31.0L / static_cast<long double>(1U << octave) *
           noise_at((static_cast<long double>(in[5]) - in[0]) / size,
                    (static_cast<long double>(in[6]) - in[1]) / size, octave + 1);
  }
  return std::exp(-in[4] * std::max(sum - (1.0L - in[3]), 0.0L) / in[3]);
}

TEST(LatticeValue, IsTheHashOfThreeIntegers) {
  Random random(91);
  std::vector<float> cases;
  for (int i = 0; i < kRandomCases; ++i)
    for (const int value :
         {random.integer(-100000, 100000), random.integer(-100000, 100000), random.integer(0, 9)})
      cases.push_back(static_cast<float>(value));
  const std::vector<float> seen = run(kLattice, cases);
  double sum = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const float* in = &cases[3 * i];
    ASSERT_NEAR(
        seen[i],
        static_cast<double>(value_at(static_cast<std::int64_t>(in[0]), static_cast<std::int64_t>(in[1]),
                                     static_cast<std::uint32_t>(in[2]))),
        1e-7)
        << i;
    sum += static_cast<double>(seen[i]);
  }
  EXPECT_NEAR(sum / static_cast<double>(seen.size()), 0.5, 0.01);
}

TEST(CloudTransmittance, IsThatOfTheNoise) {
  const std::vector<float> cases = random_cases(92, [&](Random& random) {
    return Case{random.between(-500.0f, 500.0f), random.between(-500.0f, 500.0f),
                random.between(500.0f, 5000.0f), random.between(0.2f, 1.0f),
                random.between(0.5f, 8.0f),      random.between(-2e4f, 2e4f),
                random.between(-2e4f, 2e4f)};
  });
  const std::vector<float> seen = run(kCover, cases);
  int clear = 0, cloudy = 0;
  for (std::size_t i = 0; i < seen.size() / 2; ++i) {
    const float* in = &cases[7 * i];
    // Places of a float are up to 2 mm off, and features are at least 30 m wide.
    ASSERT_NEAR(seen[2 * i], static_cast<double>(transmittance(in)), 3e-3) << i;
    ASSERT_NEAR(seen[2 * i + 1],
                static_cast<double>(noise_at(static_cast<long double>(in[5]) / in[2],
                                             static_cast<long double>(in[6]) / in[2], 3)),
                1e-4)
        << i;
    (seen[2 * i] == 1.0f ? clear : cloudy) += 1;
  }
  EXPECT_GT(clear, 1000);
  EXPECT_GT(cloudy, 1000);
}

TEST(CloudTransmittance, IsInRangeForAnyNumbersAndOneWithoutClouds) {
  Random random(93);
  std::vector<float> cases = random_special_floats(random, 7 * kRandomCases);
  for (std::size_t i = 0; i < cases.size() / 14; ++i) cases[7 * i + (i % 2 == 0 ? 3 : 4)] = 0.0f;
  const std::vector<float> seen = run(kCover, cases);
  for (std::size_t i = 0; i < seen.size() / 2; ++i) {
    ASSERT_TRUE(seen[2 * i] >= 0.0f && seen[2 * i] <= 1.0f) << i;
    if (cases[7 * i + 3] != 0.0f && cases[7 * i + 4] != 0.0f) continue;
    ASSERT_EQ(seen[2 * i], 1.0f) << i;
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
