// Core/PlanarShadow.hlsl against the line through the light, and Core/HeightFade.hlsl.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"
#include "ShaderLibrary/long_vectors.h"

namespace penumbra::shader_library_tests {
namespace {

// The inputs are position, plane and light.
const CoreFunction kOnto{"PlanarShadow",
                         "const PlanarPoint p = OntoPlane(In3(0), In4(3), In4(7)); Out3(0, p.position.xyz); "
                         "Out(3, p.height); Out(4, p.valid ? 1.0 : 0.0);",
                         11, 5};

TEST(OntoPlane, IsOnThePlaneAndOnTheLineThroughTheLight) {
  Random random(41);
  std::vector<float> cases;
  for (int i = 0; i < kRandomCases; ++i) {
    std::array<float, 11> one{};
    long double length = 0.0L;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      one[axis] = random.between(-5.0f, 5.0f);
      one[3 + axis] = random.between(-1.0f, 1.0f);
      length += static_cast<long double>(one[3 + axis]) * one[3 + axis];
      one[7 + axis] = i % 2 == 0 ? random.between(-1.0f, 1.0f) : random.between(-20.0f, 20.0f);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) one[3 + axis] /= static_cast<float>(std::sqrt(length));
    one[6] = random.between(-4.0f, 4.0f);
    one[10] = static_cast<float>(i % 2);
    cases.insert(cases.end(), one.begin(), one.end());
  }
  const std::vector<float> seen = run(kOnto, cases);
  int valid = 0;
  for (std::size_t i = 0; i < seen.size() / 5; ++i) {
    const float* in = &cases[11 * i];
    const float* out = &seen[5 * i];
    const Vector at{in[0], in[1], in[2]}, normal{in[3], in[4], in[5]};
    Vector towards{};
    for (std::size_t axis = 0; axis < 3; ++axis) towards[axis] = in[7 + axis] - in[10] * at[axis];
    const long double height = dot(normal, at) - in[6], rise = dot(normal, towards);
    if (std::fabs(height) > 1e-3L && std::fabs(rise) > 1e-3L) {
      ASSERT_EQ(out[4], height > 0.0L && rise > 0.0L ? 1.0f : 0.0f) << i;
    }
    if (out[4] == 0.0f || rise < 0.05L) continue;
    ++valid;
    ASSERT_NEAR(out[3], static_cast<double>(height), 1e-5) << i;
    const Vector place{out[0], out[1], out[2]};
    // The error is that of a float's digits at a place far away.
    const double error = 1e-4 + 2e-5 * static_cast<double>(std::sqrt(dot(place, place)));
    ASSERT_NEAR(static_cast<double>(dot(normal, place)), in[6], error) << i;
    for (std::size_t axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(out[axis], static_cast<double>(at[axis] - height / rise * towards[axis]), error) << i;
  }
  EXPECT_GT(valid, kRandomCases / 10);
}

TEST(OntoPlane, IsFiniteForAnyNumbers) {
  Random random(42);
  const std::vector<float> cases = random_special_floats(random, 11 * kRandomCases);
  for (const float value : run(kOnto, cases)) ASSERT_TRUE(std::isfinite(value));
}

TEST(HeightFade, FallsFromOneAtTheReceiverToZero) {
  const CoreFunction fade{"HeightFade", "Out(0, HeightFade(In(0), In(1)));", 2, 1};
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(run(fade, {0.0f, 2.0f, 0.5f,     2.0f, 2.0f, 2.0f, 9.0f, 2.0f,  -1.0f, 2.0f,
                       nan,  2.0f, infinity, 2.0f, 1.0f, 0.0f, 1.0f, -1.0f, 1.0f,  nan}),
            (std::vector<float>{1.0f, 0.75f, 0.0f, 0.0f, 1.0f, 1.0f, 0.0f, 1.0f, 1.0f, 1.0f}));
  std::vector<float> cases;
  for (const float height : special_floats())
    for (const float metres : special_floats()) cases.insert(cases.end(), {height, metres});
  for (const float seen : run(fade, cases)) ASSERT_TRUE(seen >= 0.0f && seen <= 1.0f);
}

}  // namespace
}  // namespace penumbra::shader_library_tests
