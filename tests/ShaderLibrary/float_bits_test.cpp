// Core/FloatBits.hlsl: NaN and infinities found and replaced, whatever their bits; all else left as it is.
#include <algorithm>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

std::vector<float> any_floats() {
  Random random(3);
  std::vector<float> inputs = special_floats();
  while (inputs.size() < std::size_t(kRandomCases)) {
    // A third of the inputs is NaN, a third anything, a third around the unit interval.
    const float anything = random.any_bits();
    const auto nan_bits = std::bit_cast<std::uint32_t>(anything) | 0x7F800000u;
    inputs.push_back(std::bit_cast<float>(nan_bits));
    if (std::fpclassify(anything) != FP_SUBNORMAL) inputs.push_back(anything);  // devices may flush those
    inputs.push_back(random.between(-0.5f, 1.5f));
  }
  return inputs;
}

TEST(FloatBits, KnowsNanAndInfinityByTheirBits) {
  expect_exact(
      {"FloatBits", "Out(0, HasNanBits(In(0)) ? 1.0 : 0.0); Out(1, HasFiniteBits(In(0)) ? 1.0 : 0.0);", 1, 2},
      any_floats(),
      [](const float* in) {
        return std::vector<Exact>{{std::isnan(in[0]) ? 1.0L : 0.0L}, {std::isfinite(in[0]) ? 1.0L : 0.0L}};
      },
      0.0L);
}

TEST(FloatBits, FiniteOrKeepsFiniteValuesAndReplacesTheRest) {
  expect_exact(
      {"FloatBits", "Out(0, FiniteOr(In(0), 7.0)); Out2(1, FiniteOr(float2(In(0), 2.0), float2(8.0, 9.0)));",
       1, 3},
      any_floats(),
      [](const float* in) {
        const bool finite = std::isfinite(in[0]);
        return std::vector<Exact>{{finite ? in[0] : 7.0L}, {finite ? in[0] : 8.0L}, {2.0L}};
      },
      0.0L);
}

TEST(FloatBits, BoundedOrLowStaysBetweenItsBounds) {
  expect_exact(
      {"FloatBits", "Out(0, BoundedOrLow(In(0), 0.25, 0.75));", 1, 1}, any_floats(),
      [](const float* in) {
        return std::vector<Exact>{{std::isnan(in[0]) ? 0.25L : std::clamp(in[0], 0.25f, 0.75f)}};
      },
      0.0L);
}

TEST(FloatBits, NanIsNoBlockerAndCannotBeBlocked) {
  for (const DepthDirection direction : kDepthDirections) {
    const float farthest = direction == DepthDirection::reversed ? 0.0f : 1.0f;
    expect_exact(
        {"FloatBits",
         "Out(0, SanitizeMapDepth(In(0))); Out(1, SanitizeReceiverDepth(In(0))); Out(2, "
         "SanitizeMapDepth(float4(0.5, 0.5, In(0), 0.5)).z); Out(3, SanitizeVisibility(In(0)));",
         1, 4},
        direction, any_floats(),
        [=](const float* in) {
          const bool nan = std::isnan(in[0]);
          const float kept = nan ? 0.0f : std::clamp(in[0], 0.0f, 1.0f);
          return std::vector<Exact>{{nan ? farthest : kept},
                                    {nan ? 1.0f - farthest : kept},
                                    {nan ? farthest : kept},
                                    {nan ? 1.0f : kept}};
        },
        0.0L);
  }
}

}  // namespace
}  // namespace penumbra::shader_library_tests
