// Core/DiscHorizon.hlsl against the area of a circular segment in long double.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

const CoreFunction kShare{"DiscHorizon", "Out(0, DiscShareAbove(In(0)));"};

long double share_above(long double edge) {
  const long double x = std::min(std::max(edge, -1.0L), 1.0L);
  return (std::acos(x) - x * std::sqrt(1.0L - x * x)) / std::acos(-1.0L);
}

TEST(DiscShareAbove, IsTheAreaAboveTheEdge) {
  Random random(101);
  std::vector<float> edges;
  for (int i = 0; i < 10 * kRandomCases; ++i) edges.push_back(random.between(-1.2f, 1.2f));
  for (int i = 0; i < kRandomCases; ++i) {  // near both ends, where the share has no second derivative
    const float small = std::pow(10.0f, random.between(-7.0f, -1.0f));
    edges.insert(edges.end(), {1.0f - small, small - 1.0f});
  }
  const std::vector<float> shares = run(kShare, edges);
  long double worst = 0.0L;
  for (std::size_t i = 0; i < edges.size(); ++i)
    worst = std::max(worst, std::fabs(shares[i] - share_above(edges[i])));
  EXPECT_LE(worst, 4e-7L);
  RecordProperty("worst", std::to_string(static_cast<double>(worst)));
}

TEST(DiscShareAbove, IsExactAtTheEndsAndInTheMiddle) {
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> edges{-infinity, -2.0f, -1.0f, 0.0f, -0.0f, 1.0f, 3e38f, infinity, std::nanf("")};
  EXPECT_EQ(run(kShare, edges), (std::vector<float>{1.0f, 1.0f, 1.0f, 0.5f, 0.5f, 0.0f, 0.0f, 0.0f, 1.0f}));
}

// A moving sun never brightens and darkens in turn.
TEST(DiscShareAbove, NeverRisesWithTheEdge) {
  std::vector<float> edges;
  for (int i = -20'000; i <= 20'000; ++i) edges.push_back(static_cast<float>(i) / 20'000.0f);
  const std::vector<float> shares = run(kShare, edges);
  for (std::size_t i = 1; i < shares.size(); ++i)
    ASSERT_LE(shares[i], shares[i - 1] + 1.2e-7f) << "at " << edges[i];
}

}  // namespace
}  // namespace penumbra::shader_library_tests
