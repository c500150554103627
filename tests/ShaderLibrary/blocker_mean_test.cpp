// Core/BlockerMean.hlsl against distributions of which the blockers are known.
#include <algorithm>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/depth_distribution.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

const CoreFunction kOfVariance{
    "BlockerMean",
    "BlockerShare b = BlockersOfVariance(In2(0), In(2), In(3)); Out(0, b.share); Out(1, b.gapSum);", 4, 2};
const CoreFunction kOfMoments{
    "BlockerMean",
    "BlockerShare b = BlockersOfMoments(In4(0), In(4), In(5)); Out(0, b.share); Out(1, b.gapSum);", 6, 2};

struct Blockers {
  double share = 0.0;
  double gap_sum = 0.0;
};

Blockers brute_force(const Depths& depths, double receiver) {
  Blockers blockers;
  for (std::size_t i = 0; i < depths.at.size(); ++i)
    if (depths.at[i] < receiver) {
      blockers.share += depths.share[i];
      blockers.gap_sum += depths.share[i] * (receiver - depths.at[i]);
    }
  return blockers;
}

// A blocker before a receiver: the case for which the paper's equation is written.
TEST(BlockersOfVariance, AreExactForOneBlockerBeforeTheReceiver) {
  Random random(61);
  std::vector<float> inputs;
  std::vector<Blockers> exact;
  while (exact.size() < std::size_t(kRandomCases)) {
    const Depths depths = drawn(random, 0.5f, 2);
    if (depths.smallest_gap() < 0.05) continue;
    const double receiver = std::max(depths.at[0], depths.at[1]);
    for (const double word : {depths.mean(1), depths.mean(2), receiver, 1e-9})
      inputs.push_back(static_cast<float>(word));
    exact.push_back(brute_force(depths, receiver));
  }
  const std::vector<float> out = run(kOfVariance, inputs);
  // The variance is 0.05^2 / 25 or more, and the moments are rounded by 2^-25 each.
  for (std::size_t i = 0; i < exact.size(); ++i) {
    ASSERT_NEAR(out[2 * i], exact[i].share, 2e-3) << i;
    ASSERT_NEAR(out[2 * i + 1], exact[i].gap_sum, 2e-7) << i;
  }
}

// The equation z_b = (z_avg - p z_r) / (1 - p) holds word by word for moments of any distribution.
TEST(BlockersOfVariance, GiveTheMeanBlockerOfThePaper) {
  Random random(62);
  std::vector<float> inputs;
  std::vector<double> means;
  for (int i = 0; i < kRandomCases; ++i) {
    const Depths depths = drawn(random, 0.5f, random.integer(3, 9));
    const float mean = static_cast<float>(depths.mean(1)), square = static_cast<float>(depths.mean(2));
    const float receiver = std::min(mean + random.between(0.05f, 0.5f), 0.5f);
    inputs.insert(inputs.end(), {mean, square, receiver, 1e-7f});
    const double m = mean, variance = std::max(square - m * m, 1e-7), behind = receiver - m;
    const double p = variance / (variance + behind * behind);
    means.push_back((m - p * receiver) / (1.0 - p));
  }
  const std::vector<float> out = run(kOfVariance, inputs);
  for (std::size_t i = 0; i < means.size(); ++i) {
    if (inputs[4 * i + 2] - inputs[4 * i] < 0.04f) continue;
    const double gap = inputs[4 * i + 2] - means[i];
    ASSERT_NEAR(out[2 * i + 1] / out[2 * i] / gap, 1.0, 3e-4) << i;
  }
}

// Where the mean lies behind the receiver, no share is known; at most Cantelli's can lie before it.
TEST(LargestBlockedShare, IsABoundOfWhatLiesBeforeTheReceiver) {
  const CoreFunction bound{"BlockerMean",
                           "float2 m = In2(0); Out(0, LargestBlockedShare(m, In(2), 1e-9)); Out(1, "
                           "BlockersOfVariance(m, In(2), 1e-9).gapSum);",
                           3, 2};
  Random random(63);
  std::vector<float> inputs;
  std::vector<Depths> all;
  for (int i = 0; i < kRandomCases; ++i) {
    all.push_back(drawn(random, 0.5f, random.integer(2, 9)));
    const double receiver = all.back().mean(1) - random.between(0.0f, 0.3f);
    for (const double word : {all.back().mean(1), all.back().mean(2), receiver})
      inputs.push_back(static_cast<float>(word));
  }
  const std::vector<float> out = run(bound, inputs);
  double sum = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Blockers blockers = brute_force(all[i], static_cast<double>(inputs[3 * i + 2]) - 1e-6);
    ASSERT_GE(out[2 * i], blockers.share - 1e-3) << i;
    ASSERT_EQ(out[2 * i + 1], 0.0f) << i;
    sum += 1.0 - out[2 * i];
  }
  EXPECT_GT(sum / kRandomCases, 0.2) << "the bound says something";
}

// Four moments know two blockers and the receiver, and two blockers alone.
TEST(BlockersOfMoments, AreExactForTwoBlockers) {
  Random random(64);
  std::vector<float> inputs;
  std::vector<Blockers> exact;
  while (exact.size() < std::size_t(kRandomCases)) {
    const Depths depths = drawn(random, 1.0f, 3);
    if (depths.smallest_gap() < 0.2) continue;
    const double receiver = *std::max_element(depths.at.begin(), depths.at.end());
    for (const int power : {1, 2, 3, 4}) inputs.push_back(static_cast<float>(depths.mean(power)));
    inputs.insert(inputs.end(), {static_cast<float>(receiver), 0.0f});
    exact.push_back(brute_force(depths, receiver));
  }
  const std::vector<float> out = run(kOfMoments, inputs);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    ASSERT_NEAR(out[2 * i], exact[i].share, 5e-3) << i;
    ASSERT_NEAR(out[2 * i + 1], exact[i].gap_sum, 5e-3) << i;
  }
}

// The distributions have two depths: the receiver's and a blocker's, or neither of them the receiver's, which
// then lies behind both. With a receiver nearer than 0.3, the distribution that is mixed in could be its
// share.
TEST(BlockersOfMoments, AreExactForDistributionsOfTwoDepths) {
  Random random(65);
  std::vector<float> inputs;
  std::vector<Blockers> exact;
  while (exact.size() < std::size_t(kRandomCases)) {
    const Depths depths = drawn(random, 0.7f, 2);
    if (depths.smallest_gap() < 0.2) continue;
    const double farther = std::max(depths.at[0], depths.at[1]);
    const double receiver = random.integer(0, 1) == 1 ? farther : farther + 0.3;
    for (const int power : {1, 2, 3, 4}) inputs.push_back(static_cast<float>(depths.mean(power)));
    inputs.insert(inputs.end(), {static_cast<float>(receiver), 6e-5f});
    exact.push_back(brute_force(depths, receiver));
  }
  const std::vector<float> out = run(kOfMoments, inputs);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    ASSERT_NEAR(out[2 * i], exact[i].share, 0.02) << i;
    ASSERT_NEAR(out[2 * i + 1], exact[i].gap_sum, 0.02) << i;
    ASSERT_NEAR(out[2 * i + 1] / out[2 * i], exact[i].gap_sum / exact[i].share, 0.05) << i;
  }
}

TEST(BlockersOfMoments, NeverClaimMoreThanThereAre) {
  Random random(66);
  std::vector<float> inputs;
  std::vector<double> shares;
  for (int i = 0; i < kRandomCases; ++i) {
    const Depths depths = drawn(random, 1.0f, random.integer(4, 12));
    const double receiver = random.between(-1.0f, 1.0f);
    for (const int power : {1, 2, 3, 4}) inputs.push_back(static_cast<float>(depths.mean(power)));
    inputs.insert(inputs.end(), {static_cast<float>(receiver), 3e-7f});
    shares.push_back(brute_force(depths, receiver).share);
  }
  const std::vector<float> out = run(kOfMoments, inputs);
  for (std::size_t i = 0; i < shares.size(); ++i) ASSERT_LE(out[2 * i], shares[i] + 5e-3) << i;
}

TEST(BlockersOfMoments, StayInRangeForMomentsOfNoDistribution) {
  Random random(67);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    for (int word = 0; word < 5; ++word) inputs.push_back(random.between(-1.0f, 1.0f));
    inputs.push_back(i % 2 == 0 ? 0.0f : 1e-3f);
  }
  const std::vector<float> out = run(kOfMoments, inputs);
  for (std::size_t i = 0; i < out.size(); i += 2) {
    ASSERT_TRUE(out[i] >= 0.0f && out[i] <= 1.0f) << out[i];
    ASSERT_TRUE(out[i + 1] >= 0.0f && out[i + 1] <= 4.0f) << out[i + 1];
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
