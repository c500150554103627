// Tests where the near and far planes come from, and the custom fit to the casters' box.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "parameters/cascades.h"
#include "parameters/random_setup.h"

namespace penumbra::parameters {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

double range_of(const Cascade& cascade) {
  return 1.0 / cascade.depth_per_metre;
}

double depth_at(const Cascade& cascade, const glm::dvec3& world) {
  return (cascade.world_to_shadow * glm::dvec4(world, 1.0)).z;
}

const Light kLight{.direction = {0.0, -1.0, 0.5}};

TEST(DepthRange, WithoutInputIsTheSphereAndTheNearPlaneOffset) {
  const CascadeSet set = fit_cascades({}, kLight, {.near_plane_offset_metres = 0.75});
  EXPECT_NEAR(range_of(set.cascades[0]), 2.0 * set.cascades[0].split_sphere.w + 0.75, 1e-9);
  EXPECT_THAT(set.depth_range_source, StartsWith("split sphere's diameter plus the near-plane offset"));
}

TEST(DepthRange, GivenInMetresReachesTowardTheLight) {
  const CascadeSet set = fit_cascades({}, kLight, {.reversed_z = false, .depth_range_metres = 500.0});
  const Cascade& cascade = set.cascades[0];
  EXPECT_NEAR(range_of(cascade), 500.0, 1e-9);
  const glm::dvec3 farthest = glm::dvec3(cascade.split_sphere) + set.light_direction * cascade.split_sphere.w;
  EXPECT_NEAR(depth_at(cascade, farthest), 1.0, 1e-12);
  EXPECT_THAT(set.depth_range_source, StartsWith("depth_range_metres (500 m)"));
}

TEST(DepthRange, ShorterThanTheSphereIsCentredOnItAndSaidSo) {
  const CascadeSet set = fit_cascades({}, kLight, {.depth_range_metres = 10.0});
  EXPECT_NEAR(depth_at(set.cascades[0], glm::dvec3(set.cascades[0].split_sphere)), 0.5, 1e-12);
  EXPECT_THAT(set.depth_range_source, HasSubstr("shorter than the largest split sphere"));
}

TEST(DepthRange, CasterBoundsFixTheNearPlane) {
  const Bounds bounds{{-10, 0, -10}, {10, 300, 10}};
  const CascadeSet set = fit_cascades({}, kLight, {.reversed_z = false, .caster_bounds = bounds});
  // The corner nearest the light is the highest, and rearmost along +z.
  const glm::dvec3 nearest(0, 300, -10);
  EXPECT_NEAR(depth_at(set.cascades[0], nearest) * range_of(set.cascades[0]), 0.2, 1e-9);
  EXPECT_THAT(set.depth_range_source, StartsWith("caster_bounds"));
}

TEST(FitToBounds, TightensTheTileToCastersInsideTheSphere) {
  const Bounds bounds{{-2, 0, 8}, {2, 3, 12}};
  const ShadowSettings loose{.caster_bounds = bounds};
  ShadowSettings tight = loose;
  tight.fit_to_bounds = true;
  const CascadeSet wide = fit_cascades({}, kLight, loose);
  const CascadeSet narrow = fit_cascades({}, kLight, tight);
  EXPECT_LT(narrow.cascades[0].texel_size_metres, 0.1 * wide.cascades[0].texel_size_metres);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 point((corner & 1) != 0 ? 2 : -2, (corner & 2) != 0 ? 3 : 0, (corner & 4) != 0 ? 12 : 8,
                           1);
    const glm::dvec4 shadow = narrow.cascades[0].world_to_shadow * point;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(shadow[axis], 0.0);
      EXPECT_LE(shadow[axis], 1.0);
    }
  }
}

TEST(FitToBounds, CastersOutsideTheCascadeLeaveTheSphereFit) {
  ShadowSettings away{.caster_bounds = Bounds{{5000, 0, 0}, {5001, 1, 1}}};
  const CascadeSet plain = fit_cascades({}, kLight, away);
  away.fit_to_bounds = true;
  EXPECT_EQ(fit_cascades({}, kLight, away).cascades[0].texel_size_metres,
            plain.cascades[0].texel_size_metres);
}

}  // namespace
}  // namespace penumbra::parameters
