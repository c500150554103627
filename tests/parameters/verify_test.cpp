// Compares the emitted floats with the second derivation in long double.
#include "parameters/verify.h"

#include <gtest/gtest.h>

#include "parameters/random_setup.h"

namespace penumbra::parameters {
namespace {

// Rounding to float costs half a ULP; double arithmetic before it may move a value across a tie.
constexpr double kBound = 0.5 + 1e-3;

void expect_within(const std::vector<CascadeErrors>& errors, double bound) {
  for (const CascadeErrors& cascade : errors) {
    EXPECT_GT(cascade.size(), 8u);
    for (const FieldError& field : cascade) EXPECT_LE(field.ulp, bound) << field.field;
  }
}

TEST(Verify, EveryFloatOfRandomFitsIsTheNearestOne) {
  SetupGenerator generator(11);
  for (int i = 0; i < 500; ++i) {
    const ShadowSetup setup = generator.next();
    expect_within(verify_fit(setup.camera, setup.light, setup.shadows, setup.fit()), kBound);
  }
}

TEST(Verify, FitsToBoundsToo) {
  SetupGenerator generator(12);
  for (int i = 0; i < 200; ++i) {
    ShadowSetup setup = generator.next();
    setup.shadows.depth_range_metres.reset();
    const glm::dvec3 corner = setup.camera.position + generator.direction() * generator.uniform(0, 40);
    setup.shadows.caster_bounds = Bounds{corner, corner + glm::dvec3(1, 2, 3) * generator.uniform(0.1, 20)};
    setup.shadows.fit_to_bounds = i % 2 == 0;
    expect_within(verify_fit(setup.camera, setup.light, setup.shadows, setup.fit()), kBound);
  }
}

// A light straight down, a camera at the origin and boxes of round numbers are cases where noise breaks ties.
TEST(Verify, RoundNumbersToo) {
  ShadowSetup setup;
  setup.camera.position = {0, 0, 0};
  setup.light.direction = {0, -1, 0};
  setup.shadows.caster_bounds = Bounds{{0, 0, 0}, {1, 1, 1}};
  setup.shadows.fit_to_bounds = true;
  expect_within(verify_fit(setup.camera, setup.light, setup.shadows, setup.fit()), kBound);
}

// 10^5 m from the origin the translations are long sums of long terms; they are still the nearest floats.
TEST(Verify, FarFromTheOriginToo) {
  SetupGenerator generator(13);
  for (int i = 0; i < 200; ++i) {
    ShadowSetup setup = generator.next();
    setup.camera.position += glm::dvec3(1e5, 0, -1e5);
    expect_within(verify_fit(setup.camera, setup.light, setup.shadows, setup.fit()), kBound);
  }
}

TEST(Verify, SeesAnErrorOfOneFloat) {
  const ShadowSetup setup;
  CascadeSet set = setup.fit();
  set.cascades[0].depth_to_radial *= 1.0 + 1.2e-7;
  EXPECT_GT(worst_ulp(verify_fit(setup.camera, setup.light, setup.shadows, set)[0]), 0.9);
}

TEST(UlpError, CountsSpacingsOfFloats) {
  EXPECT_EQ(ulp_error(1.0F, 1.0L, 0.0), 0.0);
  EXPECT_NEAR(ulp_error(1.0F, 1.0L + 0x1p-24L, 0.0), 0.5, 1e-9);
  EXPECT_NEAR(ulp_error(2.0F, 2.0L + 0x1p-22L, 0.0), 1.0, 1e-9);
  EXPECT_LT(ulp_error(0.0F, 1e-17L, 1.0), 1e-2);  // it is nothing beside a row's largest entry of 1
  EXPECT_GT(ulp_error(0.0F, 1e-17L, 0.0), 1e20);  // it is much where it stands alone
}

}  // namespace
}  // namespace penumbra::parameters
