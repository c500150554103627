// Core/HorizonBlend.hlsl against interpolation over the azimuth in long double.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

// Vulkan allows atan2 an error of 4096 units in the last place; devices keep to a hundredth of that.
constexpr double kAtan2Error = 1e-5;

using Weights = std::array<float, 8>;

const CoreFunction kWeights{"HorizonBlend",
                            "const HorizonWeights w = HorizonWeightsOf(In2(0)); for (int i = 0; i < 4; ++i) "
                            "{ Out(i, w.first[i]); Out(4 + i, w.second[i]); }",
                            2, 8};

std::vector<Weights> weights_of(const std::vector<float>& directions) {
  const std::vector<float> flat = run(kWeights, directions);
  std::vector<Weights> all(flat.size() / 8);
  for (std::size_t i = 0; i < flat.size(); ++i) all[i / 8][i % 8] = flat[i];
  return all;
}

TEST(HorizonWeights, AreThoseOfTheTwoNeighbours) {
  const std::vector<float> directions = random_cases(7, [&](Random& random) {
    const float length = std::fabs(random.magnitude(-20.0f, 20.0f));
    const float azimuth = random.between(-3.2f, 3.2f);
    return Case{length * std::sin(azimuth), length * std::cos(azimuth)};
  });
  const std::vector<Weights> all = weights_of(directions);
  const long double eighth = std::acos(-1.0L) / 4.0L;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const long double x = directions[2 * i], z = directions[2 * i + 1];
    const long double place = std::fmod(std::atan2(x, z) / eighth + 8.0L, 8.0L);
    float sum = 0.0f;
    for (int number = 0; number < 8; ++number) {
      const long double apart = std::fabs(place - number);
      const long double wanted = std::max(1.0L - std::min(apart, 8.0L - apart), 0.0L);
      ASSERT_NEAR(all[i][static_cast<std::size_t>(number)], static_cast<double>(wanted), kAtan2Error)
          << x << " " << z << " " << number;
      sum += all[i][static_cast<std::size_t>(number)];
    }
    ASSERT_NEAR(sum, 1.0f, 1.2e-7f);
    ASSERT_LE(std::count_if(all[i].begin(), all[i].end(), [](float w) { return w != 0.0f; }), 2);
  }
}

TEST(HorizonWeights, OfADirectionThatIsNoneAreThoseOfPlusZ) {
  const Weights north{1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
  const float nan = std::nanf("");
  const float infinity = std::numeric_limits<float>::infinity();
  for (const Weights& weights :
       weights_of({0.0f, 0.0f, nan, nan, nan, 1.0f, infinity, infinity, -0.0f, -0.0f}))
    EXPECT_EQ(weights, north);
}

TEST(HorizonWeights, NeverLeaveTheirRangeWhateverTheDirection) {
  std::vector<float> directions;
  for (const float x : special_floats())
    for (const float z : special_floats()) directions.insert(directions.end(), {x, z});
  for (const Weights& weights : weights_of(directions)) {
    float sum = 0.0f;
    for (const float weight : weights) {
      ASSERT_TRUE(weight >= 0.0f && weight <= 1.0f);
      sum += weight;
    }
    ASSERT_NEAR(sum, 1.0f, 1.2e-7f);
  }
}

// The horizon's angle rises by the same amount from each direction to the next.
TEST(BlendedHorizon, IsLinearBetweenTwoDirections) {
  const CoreFunction blended{"HorizonBlend",
                             "Out(0, BlendedHorizon(float4(0.0, 0.1, 0.2, 0.3), float4(0.4, 0.5, 0.6, 0.7), "
                             "HorizonWeightsOf(In2(0))));",
                             2, 1};
  std::vector<float> directions;
  for (int i = 0; i < 700; ++i) {
    const float azimuth = static_cast<float>(i) / 100.0f * std::acos(-1.0f) / 4.0f;
    directions.insert(directions.end(), {std::sin(azimuth), std::cos(azimuth)});
  }
  const std::vector<float> angles = run(blended, directions);
  for (std::size_t i = 0; i < angles.size(); ++i)
    EXPECT_NEAR(angles[i], static_cast<float>(i) / 1000.0f, 1e-6f) << i;
}

TEST(HorizonVisibility, IsTheShareOfTheSunAboveTheHorizon) {
  const CoreFunction visibility{"HorizonBlend", "Out(0, HorizonVisibility(In(0), In(1), In(2)));", 3, 1};
  const float nan = std::nanf("");
  const std::vector<float> cases{0.1f, 0.2f, 0.0f,    // above, of no size
                                 0.2f, 0.1f, 0.0f,    // below
                                 0.1f, 0.1f, 0.0f,    // its centre on the horizon: hidden
                                 0.1f, 0.1f, 0.005f,  // half of it
                                 0.1f, 0.2f, 0.005f, 0.2f,  0.1f, 0.005f, 0.1f,  0.2f,
                                 nan,  0.1f, 0.2f,   -1.0f, nan,  0.2f,   0.005f};
  EXPECT_EQ(run(visibility, cases),
            (std::vector<float>{1.0f, 0.0f, 0.0f, 0.5f, 1.0f, 0.0f, 1.0f, 1.0f, 1.0f}));
}

}  // namespace
}  // namespace penumbra::shader_library_tests
