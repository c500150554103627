// Core/GroundMap.hlsl: places and heights against long double, and what it makes of anything.
#include <gtest/gtest.h>

#include <cmath>

#include "ShaderLibrary/core_function.h"
#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {
namespace {

// The inputs are area (4), heights (2), position (3) and a stored height. The outputs are UV (2), coverage
// and metres.
const CoreFunction kGround{"GroundMap",
                           "const GroundMap ground = BoundedGroundMap(In4(0), In2(4)); const float3 at = "
                           "In3(6); const float2 uv = GroundUv(at, ground); Out2(0, uv.xy); Out(2, "
                           "GroundCoverage(at, uv)); Out(3, GroundHeight(In(9), ground));",
                           10, 4};

TEST(GroundMap, PlacesAndHeightsAreThoseOfTheArea) {
  const std::vector<float> cases = random_cases(17, [&](Random& random) {
    const float x = random.between(-5000.0f, 5000.0f), z = random.between(-5000.0f, 5000.0f);
    const float width = std::fabs(random.magnitude(0.0f, 4.0f)),
                depth = std::fabs(random.magnitude(0.0f, 4.0f));
    const float low = random.between(-100.0f, 100.0f);
    return Case{x,
                z,
                width,
                depth,
                low,
                low + random.between(1.0f, 3000.0f),
                x + width * random.between(-0.2f, 1.2f),
                random.between(-10.0f, 10.0f),
                z + depth * random.between(-0.2f, 1.2f),
                random.between(-0.1f, 1.1f)};
  });
  const std::vector<float> seen = run(kGround, cases);
  for (std::size_t i = 0; i < seen.size() / 4; ++i) {
    const float* in = &cases[10 * i];
    const float* out = &seen[4 * i];
    const long double u = (static_cast<long double>(in[6]) - in[0]) / in[2];
    const long double v = (static_cast<long double>(in[8]) - in[1]) / in[3];
    ASSERT_NEAR(out[0], static_cast<double>(u), 1e-6 * std::fabs(static_cast<double>(u)) + 1e-7);
    ASSERT_NEAR(out[1], static_cast<double>(v), 1e-6 * std::fabs(static_cast<double>(v)) + 1e-7);
    const long double outside = std::max(std::max(-u, u - 1.0L), std::max(-v, v - 1.0L));
    if (std::fabs(outside) > 1e-5L) {
      ASSERT_EQ(out[2], outside < 0.0L ? 1.0f : 0.0f);
    }
    const long double share = std::min(std::max(static_cast<long double>(in[9]), 0.0L), 1.0L);
    const long double metres = in[4] + share * (static_cast<long double>(in[5]) - in[4]);
    ASSERT_NEAR(out[3], static_cast<double>(metres), 1e-3);
  }
}

TEST(GroundMap, IsFiniteForAnyMapAndPlaceAndCoversNoPlaceThatIsNone) {
  Random random(18);
  const std::vector<float> cases = random_special_floats(random, 10 * kRandomCases);
  const std::vector<float> seen = run(kGround, cases);
  for (std::size_t i = 0; i < seen.size() / 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) ASSERT_TRUE(std::isfinite(seen[4 * i + j])) << i << " " << j;
    const bool place = std::isfinite(cases[10 * i + 6]) && std::isfinite(cases[10 * i + 8]);
    if (!place) {
      ASSERT_EQ(seen[4 * i + 2], 0.0f) << i;
    }
  }
}

// The first and the last texel's centres are the area's edges.
TEST(HeightUv, HasTexelsAtTheEdges) {
  const CoreFunction uv{"GroundMap", "Out2(0, HeightUv(In2(0), In2(2)));", 4, 2};
  EXPECT_EQ(run(uv, {0.0f, 1.0f, 4.0f, 8.0f, 0.5f, 0.5f, 2.0f, 64.0f}),
            (std::vector<float>{0.125f, 0.9375f, 0.5f, 0.5f}));
  const float nan = std::nanf("");
  for (const float value : run(uv, {0.25f, 0.75f, 0.0f, nan, 1.0f, 0.0f, -4.0f, nan}))
    EXPECT_TRUE(value >= 0.0f && value <= 1.0f) << "of a map without texels";
}

}  // namespace
}  // namespace penumbra::shader_library_tests
