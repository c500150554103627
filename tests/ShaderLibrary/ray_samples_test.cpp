// Core/RaySamples.hlsl against the law of Beer and Lambert in long double.
#include <gtest/gtest.h>

#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

const CoreFunction kFogShare{"RaySamples", "Out(0, FogShare(In(0), In(1)));", 2, 1};
const CoreFunction kSampleShare{
    "RaySamples",
    "Out(0, RaySampleShare(InInt(0), InInt(1), In(2), In(3))); OutInt(1, BoundedRaySamples(InInt(1)));", 4,
    2};

// The share of the segment's length within which that part of the fog's light is scattered.
long double fog_share(long double part, long double depth) {
  return depth == 0.0L ? part : -std::log((1.0L - part) + part * std::exp(-depth)) / depth;
}

TEST(FogShare, IsWhereThatPartOfTheLightHasBeenScattered) {
  std::vector<float> cases = random_cases(71, [&](Random& random) {
    return Case{random.between(0.0f, 1.0f), std::pow(10.0f, random.between(-6.0f, 1.8f))};
  });
  for (const float depth : {0.0f, 0.0999f, 0.1f, 1.0f, 79.0f})
    for (const float part : {0.0f, 0.5f, 1.0f}) cases.insert(cases.end(), {part, depth});
  const std::vector<float> seen = run(kFogShare, cases);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const long double part = cases[2 * i], depth = cases[2 * i + 1];
    // The place moves by this much for a step of the part, of which a float has 2^24.
    const long double steepness =
        -std::expm1(-depth) / (1.0L + part * std::expm1(-depth)) / std::max(depth, 1e-9L);
    ASSERT_NEAR(seen[i], static_cast<double>(fog_share(part, depth)),
                1e-5 + 2e-7 * static_cast<double>(std::min(steepness, 1e4L)))
        << i << " " << cases[2 * i] << " " << cases[2 * i + 1];
  }
}

TEST(FogShare, IsInRangeForAnyNumbers) {
  std::vector<float> cases;
  for (const float part : special_floats())
    for (const float depth : special_floats()) cases.insert(cases.end(), {part, depth});
  for (const float seen : run(kFogShare, cases)) ASSERT_TRUE(seen >= 0.0f && seen <= 1.0f);
}

// Each sample lies within its own part, at the jitter's share of it.
TEST(RaySampleShare, SharesTheLengthInEqualParts) {
  std::vector<float> cases;
  for (const int count : {1, 2, 5, 32, 64})
    for (int i = 0; i < count; ++i)
      for (const float jitter : {0.0f, 0.25f, 0.5f, 1.0f})
        cases.insert(cases.end(), {static_cast<float>(i), static_cast<float>(count), jitter, 0.0f});
  const std::vector<float> seen = run(kSampleShare, cases);
  for (std::size_t i = 0; i < seen.size() / 2; ++i) {
    const auto index = static_cast<double>(cases[4 * i]);
    const auto count = static_cast<double>(cases[4 * i + 1]);
    ASSERT_NEAR(seen[2 * i], (index + static_cast<double>(cases[4 * i + 2])) / count, 1e-7) << i;
  }
}

// The mean of a function at the places is its mean along the segment, weighted by what each place scatters.
TEST(RaySampleShare, WeighsAFunctionAsTheFogDoes) {
  constexpr int kCount = 64;
  for (const float depth : {0.01f, 0.5f, 3.0f, 20.0f}) {
    std::vector<float> cases;
    for (int i = 0; i < kCount; ++i)
      cases.insert(cases.end(), {static_cast<float>(i), static_cast<float>(kCount), 0.5f, depth});
    const std::vector<float> seen = run(kSampleShare, cases);
    const auto light = [](long double t) { return 0.5L + 0.5L * std::sin(5.0L * t); };
    long double mean = 0.0L, wanted = 0.0L, weights = 0.0L;
    for (std::size_t i = 0; i < kCount; ++i) mean += light(static_cast<long double>(seen[2 * i])) / kCount;
    for (int i = 0; i < 100000; ++i) {
      const long double t = (i + 0.5L) / 100000.0L, weight = std::exp(-static_cast<long double>(depth) * t);
      wanted += weight * light(t);
      weights += weight;
    }
    EXPECT_NEAR(static_cast<double>(mean), static_cast<double>(wanted / weights), 2e-3) << depth;
  }
}

TEST(RaySampleShare, RisesWithTheIndexAndStaysInRange) {
  Random random(72);
  std::vector<float> cases;
  for (int i = 0; i < kRandomCases; ++i) {
    const std::vector<float> odd = random_special_floats(random, 2);
    const int index = random.integer(-3, 70);
    for (const int next : {0, 1})
      cases.insert(cases.end(), {static_cast<float>(index + next),
                                 static_cast<float>(random.integer(0, 1) == 0 ? 64 : 7), odd[0], odd[1]});
    cases[cases.size() - 3] = cases[cases.size() - 7];  // the sample counts are equal
  }
  const std::vector<float> seen = run(kSampleShare, cases);
  for (std::size_t i = 0; i < seen.size() / 4; ++i) {
    ASSERT_TRUE(seen[4 * i] >= 0.0f && seen[4 * i] <= 1.0f) << i;
    ASSERT_GE(seen[4 * i + 2], seen[4 * i]) << i;
  }
}

TEST(BoundedRaySamples, Are1To64) {
  std::vector<float> cases;
  const std::vector<int> counts{-1000000000, -1, 0, 1, 17, 64, 65, 1000000000};
  for (const int count : counts)
    cases.insert(cases.end(), {static_cast<float>(0), static_cast<float>(count), 0.5f, 0.0f});
  const std::vector<float> seen = run(kSampleShare, cases);
  for (std::size_t i = 0; i < counts.size(); ++i)
    EXPECT_EQ(static_cast<int>(seen[2 * i + 1]), std::min(std::max(counts[i], 1), 64));
}

}  // namespace
}  // namespace penumbra::shader_library_tests
