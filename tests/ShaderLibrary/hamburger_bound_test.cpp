// Core/HamburgerBound.hlsl against distributions of which the answer is known.
#include <algorithm>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/depth_distribution.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

const CoreFunction kBound{"HamburgerBound", "Out(0, HamburgerBound(In4(0), In(4), In(5)));", 6, 1};

void add_case(std::vector<float>& inputs, const Depths& depths, double receiver, float mix) {
  for (const int power : {1, 2, 3, 4}) inputs.push_back(static_cast<float>(depths.mean(power)));
  inputs.insert(inputs.end(), {static_cast<float>(receiver), mix});
}

// Three depths are the canonical representation of their moments, so each has its share.
TEST(CanonicalWeight, IsTheShareOfOneOfThreeDepths) {
  const CoreFunction weight{"HamburgerBound", "Out(0, CanonicalWeight(FactorHankel(In4(0)), In(4)));", 5, 1};
  Random random(46);
  std::vector<float> inputs;
  std::vector<double> shares;
  while (shares.size() < std::size_t(kRandomCases)) {
    const Depths depths = drawn(random, 1.0f, 3);
    if (depths.smallest_gap() < 0.2) continue;
    for (const int power : {1, 2, 3, 4}) inputs.push_back(static_cast<float>(depths.mean(power)));
    inputs.push_back(static_cast<float>(depths.at[0]));
    shares.push_back(depths.share[0]);
  }
  const std::vector<float> weights = run(weight, inputs);
  for (std::size_t i = 0; i < shares.size(); ++i) ASSERT_NEAR(weights[i], shares[i], 5e-3) << i;
}

TEST(CanonicalDepths, AreTheOtherTwoOfThreeDepths) {
  const CoreFunction others{"HamburgerBound",
                            "float2 d = CanonicalDepths(FactorHankel(In4(0)), In(4)); Out(0, min(d.x, d.y)); "
                            "Out(1, max(d.x, d.y));",
                            5, 2};
  Random random(48);
  std::vector<float> inputs;
  std::vector<double> exact;
  while (exact.size() < std::size_t(2 * kRandomCases)) {
    const Depths depths = drawn(random, 1.0f, 3);
    if (depths.smallest_gap() < 0.2) continue;
    for (const int power : {1, 2, 3, 4}) inputs.push_back(static_cast<float>(depths.mean(power)));
    inputs.push_back(static_cast<float>(depths.at[0]));
    exact.push_back(std::min(depths.at[1], depths.at[2]));
    exact.push_back(std::max(depths.at[1], depths.at[2]));
  }
  const std::vector<float> found = run(others, inputs);
  for (std::size_t i = 0; i < exact.size(); ++i) ASSERT_NEAR(found[i], exact[i], 5e-3) << i;
}

TEST(MixedMoments, AreThoseOfTheMixedDistribution) {
  const CoreFunction mixed{"HamburgerBound", "Out4(0, MixedMoments(In4(0), In(4)));", 5, 4};
  Random random(49);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    for (int word = 0; word < 4; ++word) inputs.push_back(random.between(-1.0f, 1.0f));
    inputs.push_back(random.between(0.0f, 0.1f));
  }
  const std::vector<float> out = run(mixed, inputs);
  const double smooth[4] = {0.0, 0.375, 0.0, 0.375};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double mix = inputs[i / 4 * 5 + 4];
    ASSERT_NEAR(out[i], (1.0 - mix) * inputs[i / 4 * 5 + i % 4] + mix * smooth[i % 4], 2e-7) << i;
  }
}

// They are orthogonal polynomials of the distribution: means of both and of their product are 0.
TEST(ReducedPowers, AreOrthogonal) {
  const CoreFunction powers{"HamburgerBound", "Out2(0, ReducedPowers(FactorHankel(In4(0)), In(4)));", 5, 2};
  constexpr int kDepths = 5;
  Random random(47);
  std::vector<float> inputs;
  std::vector<Depths> all;
  for (int i = 0; i < kRandomCases / kDepths; ++i) {
    all.push_back(drawn(random, 1.0f, kDepths));
    for (const double depth : all.back().at) {
      for (const int power : {1, 2, 3, 4}) inputs.push_back(static_cast<float>(all.back().mean(power)));
      inputs.push_back(static_cast<float>(depth));
    }
  }
  const std::vector<float> y = run(powers, inputs);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double variance = all[i].mean(2) - all[i].mean(1) * all[i].mean(1);
    if (variance < 0.01) continue;
    double first = 0.0, second = 0.0, product = 0.0;
    for (std::size_t k = 0; k < kDepths; ++k) {
      const double share = all[i].share[k];
      const double a = y[2 * (kDepths * i + k)], b = y[2 * (kDepths * i + k) + 1];
      first += share * a;
      second += share * b;
      product += share * a * b;
    }
    ASSERT_NEAR(first, 0.0, 1e-6) << i;
    ASSERT_NEAR(second, 0.0, 1e-4) << i;
    ASSERT_NEAR(product, 0.0, 1e-4) << i;
  }
}

// With two occluders and the receiver, the bound is the share at or behind the receiver.
TEST(HamburgerBound, IsExactForThreeDepths) {
  Random random(41);
  std::vector<float> inputs;
  std::vector<double> shares;
  while (shares.size() < std::size_t(kRandomCases)) {
    const Depths depths = drawn(random, 1.0f, 3);
    if (depths.smallest_gap() < 0.2) continue;
    const double receiver = depths.at[static_cast<std::size_t>(random.integer(0, 2))];
    add_case(inputs, depths, receiver, 0.0f);
    shares.push_back(depths.behind(receiver));
  }
  const std::vector<float> bounds = run(kBound, inputs);
  // The last pivot is at least 1e-4 of the moments, which are rounded to 2^-24.
  for (std::size_t i = 0; i < shares.size(); ++i) ASSERT_NEAR(bounds[i], shares[i], 5e-3) << i;
}

TEST(HamburgerBound, IsABoundForManyDepths) {
  Random random(42);
  std::vector<float> inputs;
  std::vector<double> shares;
  for (int i = 0; i < kRandomCases; ++i) {
    const Depths depths = drawn(random, 1.0f, random.integer(4, 12));
    const double receiver = random.between(-1.0f, 1.0f);
    add_case(inputs, depths, receiver, 3e-7f);
    shares.push_back(depths.behind(receiver));
  }
  const std::vector<float> bounds = run(kBound, inputs);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    ASSERT_GE(bounds[i], shares[i] - 5e-3) << i;
    ASSERT_LE(bounds[i], 1.0f) << i;
  }
}

// No other bound from these moments is smaller: some distribution of four depths reaches it. The bound must
// lie below that of two moments, which know less.
TEST(HamburgerBound, IsAtMostThatOfTwoMoments) {
  Random random(43);
  std::vector<float> inputs;
  std::vector<double> chebyshev;
  for (int i = 0; i < kRandomCases; ++i) {
    const Depths depths = drawn(random, 1.0f, random.integer(3, 12));
    const double receiver = random.between(-1.0f, 1.0f);
    add_case(inputs, depths, receiver, 0.0f);
    const double variance = depths.mean(2) - depths.mean(1) * depths.mean(1);
    const double behind = receiver - depths.mean(1);
    chebyshev.push_back(behind > 0.0 ? variance / (variance + behind * behind) : 1.0);
  }
  const std::vector<float> bounds = run(kBound, inputs);
  double sum = 0.0;
  for (std::size_t i = 0; i < chebyshev.size(); ++i) {
    ASSERT_LE(bounds[i], chebyshev[i] + 5e-3) << i;
    sum += chebyshev[i] - bounds[i];
  }
  EXPECT_GT(sum / kRandomCases, 0.05) << "four moments know more than two";
}

// One depth with rounded moments is lit before it, and dark behind it beyond what the mix leaves uncertain.
TEST(HamburgerBound, ToldApartFromOneDepth) {
  Random random(44);
  std::vector<float> inputs;
  std::vector<bool> behind;
  for (int i = 0; i < kRandomCases; ++i) {
    const Depths depth = drawn(random, 0.9f, 1);
    const bool is_behind = random.integer(0, 1) == 1;
    add_case(inputs, depth, depth.at[0] + (is_behind ? 0.02 : -0.02), 3e-7f);
    behind.push_back(is_behind);
  }
  const std::vector<float> bounds = run(kBound, inputs);
  for (std::size_t i = 0; i < behind.size(); ++i) {
    if (behind[i])
      ASSERT_LT(bounds[i], 0.02f) << i;
    else
      ASSERT_GT(bounds[i], 0.99f) << i;
  }
}

TEST(HamburgerBound, StaysInRangeForMomentsOfNoDistribution) {
  Random random(45);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    for (int word = 0; word < 5; ++word) inputs.push_back(random.between(-1.0f, 1.0f));
    inputs.push_back(i % 2 == 0 ? 0.0f : 1e-3f);
  }
  expect_within(kBound, inputs, 0.0f, 1.0f);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
