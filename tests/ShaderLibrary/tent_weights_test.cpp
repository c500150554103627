// Core/TentWeights.hlsl: the fetches reproduce a tent's area over every texel, and their weights sum to 1.
#include <algorithm>
#include <array>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

constexpr int kOffsets = 1000000;

// Area of the tent of this width, total 1, below x; x from the tent's left end.
long double tent_area_below(long double x, long double width) {
  if (x <= 0.0L) return 0.0L;
  if (x >= width) return 1.0L;
  const long double half = 0.5L * width;
  return x <= half ? x * x / (2.0L * half * half) : 1.0L - (width - x) * (width - x) / (2.0L * half * half);
}

std::string fetches(int taps) {
  return "const TentAxis axis = TentFetches(In(0), " + std::to_string(taps) +
         "); for (int i = 0; i < 4; ++i) { Out(uint(i), axis.weight[i]); Out(uint(4 + i), axis.position[i]); "
         "}";
}

std::vector<float> offsets() {
  std::vector<float> inputs(kOffsets);
  for (int i = 0; i < kOffsets; ++i) inputs[std::size_t(i)] = float((i + 0.5) / kOffsets);
  // Texel centres and corners, and their neighbours.
  for (const float edge : {0.0f, 0.5f, 1.0f}) {
    inputs.insert(inputs.end(), {edge, std::nextafter(edge, -1.0f), std::nextafter(edge, 2.0f)});
  }
  return inputs;
}

class TentWeights : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(EverySize, TentWeights, ::testing::Values(2, 3, 4));

// The weights are summed as a filter does, in float, in both directions: the sum is exactly 1, so fully lit
// is exactly 1.
TEST_P(TentWeights, SumToExactlyOneInAnyOrder) {
  const std::vector<float> inputs = offsets();
  const std::vector<float> results = run({"TentWeights", fetches(GetParam()), 1, 8}, inputs);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const float* weight = &results[8 * i];
    ASSERT_EQ(((weight[0] + weight[1]) + weight[2]) + weight[3], 1.0f) << "offset " << inputs[i];
    ASSERT_EQ(weight[0] + (weight[1] + (weight[2] + weight[3])), 1.0f) << "offset " << inputs[i];
    for (int k = 0; k < 4; ++k) ASSERT_GE(weight[k], 0.0f) << "offset " << inputs[i];
    for (int k = GetParam(); k < 4; ++k) ASSERT_EQ(weight[k], 0.0f) << "offset " << inputs[i];
  }
}

// Each fetch is taken apart into texels by its place between their centres; each texel then weighs its area
// under the tent. Weights lie on a grid of 2^-23 (two ULP of 1 for the fetch that takes the rest); the place
// of a fetch, a float near 4, is good to 2^-22, and moves weight between its two texels.
TEST_P(TentWeights, WeighEveryTexelByItsAreaUnderTheTent) {
  const int taps = GetParam();
  const long double width = 2.0L * taps - 1.0L;
  const std::vector<float> inputs = offsets();
  const std::vector<float> results = run({"TentWeights", fetches(taps), 1, 8}, inputs);
  long double worst = 0.0L;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    std::array<long double, 16> texel_weight{};  // texels -8 .. 7
    for (int k = 0; k < taps; ++k) {
      const long double weight = results[8 * i + std::size_t(k)];
      const long double place = results[8 * i + 4 + std::size_t(k)] - 0.5L;
      const long double right_share = place - std::floor(place);
      const auto left = static_cast<std::size_t>(std::floor(place) + 8.0L);
      texel_weight.at(left) += weight * (1.0L - right_share);
      texel_weight.at(left + 1) += weight * right_share;
    }
    const long double start = inputs[i] - 0.5L * width;
    for (std::size_t k = 0; k < texel_weight.size(); ++k) {
      const long double left = static_cast<long double>(k) - 8.0L - start;
      const long double area = tent_area_below(left + 1.0L, width) - tent_area_below(left, width);
      worst = std::max(worst, std::fabs(texel_weight[k] - area));
    }
  }
  EXPECT_LE(worst, 4.0L * 0x1p-23L) << "in units of weight; the whole tent weighs 1";
}

// The area has sums of products without cancellation: four roundings of each side, one of the sum, one of the
// scale.
TEST(TentMass, IsTheAreaBetweenItsBounds) {
  const std::vector<float> inputs = random_cases(4, [&](Random& random) {
    const float width = 3.0f + 2.0f * float(random.integer(0, 2));
    const float a = random.between(-1.0f, width + 1.0f);
    return Case{a, a + random.between(0.0f, 2.0f), width};
  });
  expect_exact(
      {"TentWeights", "Out(0, TentMass(In(0), In(1), In(2)));", 3, 1}, inputs,
      [](const float* in) {
        const long double mass = tent_area_below(in[1], in[2]) - tent_area_below(in[0], in[2]);
        // b - a of clamped bounds is exact or rounded at the size of the bounds themselves.
        return std::vector<Exact>{{mass, std::max(mass, 1.0L / in[2])}};
      },
      4.0L);
}

TEST(RoundToWeightGrid, GivesTheNearestMultiple) {
  Random random(5);
  std::vector<float> inputs = {0.0f, 1.0f, 0.5f, 0x1p-24f, 0x1p-23f};
  while (inputs.size() < std::size_t(kRandomCases)) inputs.push_back(random.between(0.0f, 1.0f));
  // 2^23 w + 1/2 may itself round up to a whole number when w lies just below the middle, so the bound is not
  // quite 1/2.
  expect_exact(
      {"TentWeights", "Out(0, RoundToWeightGrid(In(0)));", 1, 1}, inputs,
      [](const float* in) {
        return std::vector<Exact>{{in[0], 1.0L}};
      },
      0.51L);
  const std::vector<float> results = run({"TentWeights", "Out(0, RoundToWeightGrid(In(0)));", 1, 1}, inputs);
  for (const float result : results) ASSERT_EQ(std::fmod(result, 0x1p-23f), 0.0f) << result;
}

}  // namespace
}  // namespace penumbra::shader_library_tests
