// Core/MomentBounds.hlsl: Chebyshev's bound against distributions of which the answer is known.
#include <algorithm>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/depth_distribution.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

const CoreFunction kBound{"MomentBounds", "Out(0, ChebyshevBound(In2(0), In(2), In(3)));", 4, 1};

// With an occluder and the receiver behind it, the bound is the receiver's share.
TEST(MomentBounds, AreExactForTwoDepths) {
  Random random(31);
  std::vector<float> inputs;
  std::vector<double> shares;
  while (shares.size() < std::size_t(kRandomCases)) {
    Depths depths = drawn(random, 0.5f, 2);
    std::sort(depths.at.begin(), depths.at.end());
    if (depths.at[1] - depths.at[0] < 0.05) continue;
    inputs.insert(inputs.end(), {static_cast<float>(depths.mean(1)), static_cast<float>(depths.mean(2)),
                                 static_cast<float>(depths.at[1]), 1e-12f});
    shares.push_back(depths.share[1]);
  }
  const std::vector<float> bounds = run(kBound, inputs);
  // The moments are rounded to 2^-25 of 1/4; the variance of two depths 0.05 apart is at least 1e-4.
  for (std::size_t i = 0; i < shares.size(); ++i) ASSERT_NEAR(bounds[i], shares[i], 5e-4) << i;
}

TEST(MomentBounds, AreBoundsForManyDepths) {
  Random random(32);
  std::vector<float> inputs;
  std::vector<double> shares;
  for (int i = 0; i < kRandomCases; ++i) {
    const Depths depths = drawn(random, 0.5f, random.integer(2, 12));
    const double receiver = random.between(-0.5f, 0.5f);
    inputs.insert(inputs.end(), {static_cast<float>(depths.mean(1)), static_cast<float>(depths.mean(2)),
                                 static_cast<float>(receiver), 1e-12f});
    shares.push_back(depths.behind(receiver));
  }
  const std::vector<float> bounds = run(kBound, inputs);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    ASSERT_GE(bounds[i], shares[i] - 1e-3) << i;
    ASSERT_LE(bounds[i], 1.0f) << i;
  }
}

TEST(MomentBounds, AreOneAtAndBeforeTheMean) {
  const std::vector<float> bounds = run(kBound, {0.25f, 0.0625f, 0.25f, 1e-9f, 0.25f, 0.125f, -0.5f, 1e-9f});
  EXPECT_EQ(bounds, (std::vector<float>{1.0f, 1.0f}));
}

TEST(MomentBounds, LessBleedingIsDarkUpToItsAmount) {
  const CoreFunction reduce{"MomentBounds", "Out(0, ReduceBleeding(In(0), In(1)));", 2, 1};
  const std::vector<float> reduced =
      run(reduce, {1.0f, 0.25f, 0.25f, 0.25f, 0.625f, 0.25f, 0.1f, 0.25f, 0.3f, 0.0f});
  EXPECT_EQ(reduced, (std::vector<float>{1.0f, 0.0f, 0.5f, 0.0f, 0.3f}));
}

}  // namespace
}  // namespace penumbra::shader_library_tests
