// Core/DepthConvention.hlsl: every answer in one convention is the answer of the mirrored depths in the
// other.
#include <algorithm>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/exactness.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

// The distance from the light in stored units, whichever way the depth runs.
long double depth_behind_near(float depth, DepthDirection direction) {
  return direction == DepthDirection::reversed ? 1.0L - depth : static_cast<long double>(depth);
}

std::vector<float> depth_pairs() {
  Random random(1);
  std::vector<float> inputs;
  for (const float a : {0.0f, 1.0f, 0.5f, 5.9604645e-8f, 0.99999994f, 1e-10f}) {
    for (const float b : {0.0f, 1.0f, 0.5f, 5.9604645e-8f, 0.99999994f, 1e-10f})
      inputs.insert(inputs.end(), {a, b});
  }
  for (int i = 0; i < kRandomCases; ++i) {
    const float a = random.between(0.0f, 1.0f);
    // Every other pair lies within a few ULP, where comparisons go wrong.
    const float b = i % 2 == 0 ? random.between(0.0f, 1.0f) : std::nextafter(a, float(random.integer(0, 1)));
    inputs.insert(inputs.end(), {a, b});
  }
  return inputs;
}

class DepthConvention : public ::testing::TestWithParam<DepthDirection> {};
INSTANTIATE_TEST_SUITE_P(BothDirections, DepthConvention, ::testing::ValuesIn(kDepthDirections));

// One subtraction, correctly rounded, is off by 1/2 ULP. The product with +-1 is exact.
TEST_P(DepthConvention, DepthGapIsHowMuchNearerTheMapIs) {
  const CoreFunction scalar{"DepthConvention", "Out(0, DepthGap(In(0), In(1)));", 2, 1};
  const CoreFunction vector{"DepthConvention",
                            "Out(0, DepthGap(float4(0, 0, 0, In(0)), float4(0, 0, 0, In(1))).w);", 2, 1};
  for (const CoreFunction& function : {scalar, vector}) {
    expect_exact(
        function, GetParam(), depth_pairs(),
        [](const float* in) {
          return std::vector<Exact>{
              {depth_behind_near(in[1], GetParam()) - depth_behind_near(in[0], GetParam())}};
        },
        0.5L);
  }
}

TEST_P(DepthConvention, IsBlockerHoldsOnlyForDepthsStrictlyNearer) {
  expect_exact(
      {"DepthConvention", "Out(0, IsBlocker(In(0), In(1)) ? 1.0 : 0.0);", 2, 1}, GetParam(), depth_pairs(),
      [](const float* in) {
        const bool nearer = GetParam() == DepthDirection::reversed ? in[0] > in[1] : in[0] < in[1];
        return std::vector<Exact>{{nearer ? 1.0L : 0.0L}};
      },
      0.0L);
}

TEST_P(DepthConvention, MoveTowardLightRaisesTheGapByTheDistance) {
  expect_exact(
      {"DepthConvention", "Out(0, MoveTowardLight(In(0), In(1)));", 2, 1}, GetParam(), depth_pairs(),
      [](const float* in) {
        const long double way = GetParam() == DepthDirection::reversed ? 1.0L : -1.0L;
        return std::vector<Exact>{{in[0] + way * in[1]}};
      },
      0.5L);
}

TEST_P(DepthConvention, LargestGapIsTheDistanceToTheNearPlane) {
  expect_exact(
      {"DepthConvention", "Out(0, LargestGap(In(0)));", 2, 1}, GetParam(), depth_pairs(),
      [](const float* in) {
        return std::vector<Exact>{{std::max(depth_behind_near(in[0], GetParam()), 0.0L)}};
      },
      0.5L);
}

TEST_P(DepthConvention, NothingKeptBehindTheNearPlaneReachesIt) {
  Random random(2);
  std::vector<float> inputs;
  for (const float value : special_floats()) {
    if (!std::isnan(value)) inputs.push_back(value);
  }
  while (inputs.size() < std::size_t(kRandomCases)) inputs.push_back(random.between(-0.5f, 1.5f));
  const CoreFunction function{
      "DepthConvention",
      "Out(0, KeepBehindNearPlane(In(0))); Out(1, KeepBehindNearPlane(float4(0, In(0), 0, 0)).y); Out(2, "
      "LimitToNearPlane(float4(0, 0, min(max(In(0), -2.0), 2.0), 0)).z);",
      1, 3};
  const float step = 5.9604645e-8f;
  const bool reversed = GetParam() == DepthDirection::reversed;
  expect_exact(
      function, GetParam(), inputs,
      [=](const float* in) {
        const float kept = std::clamp(in[0], reversed ? 0.0f : step, reversed ? 1.0f - step : 1.0f);
        const float bounded = std::clamp(in[0], -2.0f, 2.0f);
        const float limited = reversed ? std::min(bounded, 1.0f - step) : std::max(bounded, step);
        return std::vector<Exact>{{kept}, {kept}, {limited}};
      },
      0.0L);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
