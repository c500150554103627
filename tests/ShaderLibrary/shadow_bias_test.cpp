// Core/ShadowBias.hlsl against the rules it restates, in long double.
#include <algorithm>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

// The bias is two products.
TEST(ShadowBias, CasterBiasGrowsWithTexelAndKernel) {
  const std::vector<float> inputs = random_cases(16, [&](Random& random) {
    return Case{random.between(0.0f, 10.0f), random.between(0.0f, 10.0f), random.between(1e-4f, 1.0f),
                random.between(1.0f, 4.0f)};
  });
  expect_exact(
      {"ShadowBias", "Out2(0, CasterBiasMetres(In2(0), In(2), In(3)));", 4, 2}, inputs,
      [](const float* in) {
        const long double kernel = static_cast<long double>(in[2]) * in[3];
        return std::vector<Exact>{{-in[0] * kernel}, {-in[1] * kernel}};
      },
      1.5L);
}

// The largest terms are the position and the two offsets; a dot product and six more roundings at their size.
TEST(ShadowBias, CastersMoveAwayFromTheLightAndInward) {
  Random random(17);
  std::vector<float> inputs;
  for (int i = 0; i < kRandomCases; ++i) {
    for (int axis = 0; axis < 3; ++axis)
      inputs.push_back(i % 8 == 0 ? random.magnitude(4.0f, 5.0f) : random.between(-50.0f, 50.0f));
    for (int vector = 0; vector < 2; ++vector) {
      float v[3];
      float length = 0.0f;
      for (float& c : v) c = random.between(-1.0f, 1.0f);
      length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + 1e-6f;
      for (const float c : v) inputs.push_back(c / length);
    }
    inputs.push_back(random.between(-0.5f, 0.0f));
    inputs.push_back(random.between(-0.5f, 0.0f));
  }
  expect_exact(
      {"ShadowBias", "Out3(0, BiasCaster(In3(0), In3(3),In3(6), In2(9)));", 11, 3}, inputs,
      [](const float* in) {
        long double cosine = 0.0L;
        for (int axis = 0; axis < 3; ++axis) cosine += static_cast<long double>(in[3 + axis]) * in[6 + axis];
        cosine = std::clamp(cosine, 0.0L, 1.0L);
        std::vector<Exact> moved;
        for (int axis = 0; axis < 3; ++axis) {
          const long double along = static_cast<long double>(in[6 + axis]) * in[9];
          const long double inward = static_cast<long double>(in[3 + axis]) * (1.0L - cosine) * in[10];
          moved.push_back(
              {in[axis] + along + inward, std::max({std::fabs(static_cast<long double>(in[axis])),
                                                    std::fabs(along) + std::fabs(inward), 0.05L})});
        }
        return moved;
      },
      4.0L);
}

// The difference 1 - c^2 cancels near c = 1, where the slope itself is small: the error is of the size of one
// slope unit. Square root and division have 2.5 ULP each in Vulkan.
TEST(ShadowBias, SlopeScaledBiasFollowsTheTangent) {
  const std::vector<float> inputs = random_cases(18, [&](Random& random) {
    return Case{random.between(0.0f, 0.01f), random.between(0.0f, 0.01f), random.between(-0.1f, 0.999f)};
  });
  expect_exact(
      {"ShadowBias", "Out(0, SlopeScaledBias(In(0), In(1), In(2), 0.25));", 3, 1}, inputs,
      [](const float* in) {
        const long double c = std::clamp(static_cast<long double>(in[2]), 1e-3L, 1.0L);
        const long double slope = std::sqrt(1.0L - c * c) / c;
        // The slope's derivative by 1 - c^2 is 1 / (2 c sqrt(1 - c^2)), which magnifies one rounding of 1 -
        // c^2.
        const long double magnified = in[1] / (c * std::sqrt(1.0L - c * c));
        return std::vector<Exact>{
            {std::min(in[0] + in[1] * slope, 0.25L), std::max(in[0] + in[1] * slope, magnified)}};
      },
      8.0L);
}

TEST(ShadowBias, AdaptiveBiasIsThePlanesRiseUnderTheKernel) {
  const std::vector<float> inputs = random_cases(19, [&](Random& random) {
    return Case{random.between(-50.0f, 50.0f), random.between(-50.0f, 50.0f), random.between(0.0f, 0.01f),
                random.between(0.0f, 0.01f)};
  });
  // The highest corner of the kernel is found by looking at all four. The bias has two products and a sum.
  expect_exact(
      {"ShadowBias", "Out(0, AdaptiveBias(In2(0), In2(2), 0.25));", 4, 1}, inputs,
      [](const float* in) {
        long double rise = 0.0L;
        for (const long double u : {-1.0L, 1.0L}) {
          for (const long double v : {-1.0L, 1.0L})
            rise = std::max(rise, u * in[0] * in[2] + v * in[1] * in[3]);
        }
        return std::vector<Exact>{{std::min(rise, 0.25L)}};
      },
      2.0L);
}

TEST(ShadowBias, ReceiverBiasesAreBoundedForAnyInput) {
  Random random(20);
  std::vector<float> inputs(4 * std::size_t(kRandomCases));
  for (float& value : inputs) value = random.any_bits();
  expect_within(
      {"ShadowBias",
       "Out(0, SlopeScaledBias(In(0), In(1), In(2), 0.25)); Out(1, AdaptiveBias(In2(0), In2(2), 0.25));", 4,
       2},
      inputs, 0.0f, 0.25f);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
