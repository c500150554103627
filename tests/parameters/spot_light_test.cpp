// Compares a spot light's shadow map with rays and similar triangles in long double.
#include "parameters/spot_light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "input/input_error.h"
#include "parameters/random_setup.h"

namespace penumbra::parameters {
namespace {

using Real = long double;
using Vec3 = glm::vec<3, Real>;
using Vec4 = glm::vec<4, Real>;
using Mat4 = glm::mat<4, 4, Real>;
using testing::HasSubstr;

SpotLight random_light(SetupGenerator& generator) {
  SpotLight light;
  light.position = {generator.uniform(-9, 9), generator.uniform(-9, 9), generator.uniform(-9, 9)};
  light.direction = {generator.uniform(-1, 1), generator.uniform(-1, 1), generator.uniform(0.1, 1)};
  light.outer_angle_degrees = generator.uniform(5, 120);
  light.inner_angle_degrees = generator.uniform(0, light.outer_angle_degrees);
  light.shadow_guard_degrees = generator.uniform(0, 20);
  light.source_radius_metres = generator.uniform(0.01, 0.3);
  light.shadow_near_plane_metres = generator.uniform(0.05, 0.5);
  light.range_metres = generator.uniform(2, 40);
  return light;
}

ShadowSettings settings_of(bool reversed_z, ClipDepth clip_depth) {
  ShadowSettings settings;
  settings.resolution = 512;
  settings.reversed_z = reversed_z;
  settings.clip_depth = clip_depth;
  return settings;
}

void for_random_maps(const std::function<void(const SpotShadow&, SetupGenerator&)>& check) {
  SetupGenerator generator(71);
  for (int i = 0; i < 200; ++i) {
    const SpotLight light = random_light(generator);
    for (const bool reversed_z : {false, true}) {
      for (const ClipDepth clip : {ClipDepth::zero_to_one, ClipDepth::minus_one_to_one}) {
        check(spot_shadow(light, settings_of(reversed_z, clip)), generator);
      }
    }
  }
}

// A point at an axial depth, which lies across the light by shares of the map's half width there.
Vec3 point_of(const SpotShadow& shadow, Real depth, Real across, Real along) {
  const Vec3 forward(shadow.light.direction);
  // The view's first rows are the light's right and up.
  const Vec3 right(shadow.view[0][0], shadow.view[1][0], shadow.view[2][0]);
  const Vec3 up(shadow.view[0][1], shadow.view[1][1], shadow.view[2][1]);
  const Real angle = Real(shadow.light.outer_angle_degrees) + shadow.light.shadow_guard_degrees;
  const Real half_width = depth * std::tan(angle * std::numbers::pi_v<Real> / 360);
  return Vec3(shadow.light.position) + depth * forward + half_width * (across * right + along * up);
}

Vec3 in_map(const SpotShadow& shadow, const Vec3& world) {
  const Vec4 mapped = Mat4(shadow.world_to_shadow) * Vec4(world, 1);
  return Vec3(mapped) / mapped.w;
}

TEST(SpotShadow, ItsAxesAreUnitys) {
  for_random_maps([](const SpotShadow& shadow, SetupGenerator&) {
    const glm::dvec3 right(shadow.view[0][0], shadow.view[1][0], shadow.view[2][0]);
    const glm::dvec3 up(shadow.view[0][1], shadow.view[1][1], shadow.view[2][1]);
    ASSERT_LT(glm::length(glm::cross(right, up) - shadow.light.direction), 1e-12) << "left-handed";
    ASSERT_NEAR(glm::length(right), 1.0, 1e-12);
    ASSERT_GE(up.y, 0.0);
  });
}

TEST(SpotShadow, MapsItsPyramidToTheTile) {
  for_random_maps([](const SpotShadow& shadow, SetupGenerator& generator) {
    const Real depth = generator.uniform(shadow.light.shadow_near_plane_metres, shadow.light.range_metres);
    const Real across = generator.uniform(-1, 1), along = generator.uniform(-1, 1);
    const Vec3 mapped = in_map(shadow, point_of(shadow, depth, across, along));
    ASSERT_NEAR(double(mapped.x), double(0.5L + 0.5L * across), 1e-12);
    ASSERT_NEAR(double(mapped.y), double(0.5L + 0.5L * along), 1e-12);
    const Real near = shadow.light.shadow_near_plane_metres, far = shadow.light.range_metres;
    const Real conventional = (1 / near - 1 / depth) / (1 / near - 1 / far);
    ASSERT_NEAR(double(mapped.z), double(shadow.reversed_z ? 1 - conventional : conventional), 1e-11);
  });
}

TEST(SpotShadow, ItsMatricesAgree) {
  for_random_maps([](const SpotShadow& shadow, SetupGenerator& generator) {
    const Real depth = generator.uniform(shadow.light.shadow_near_plane_metres, shadow.light.range_metres);
    const Vec3 point = point_of(shadow, depth, generator.uniform(-1, 1), generator.uniform(-1, 1));
    const Vec4 clip = Mat4(shadow.projection) * (Mat4(shadow.view) * Vec4(point, 1));
    const Vec3 ndc = Vec3(clip) / clip.w;
    const Real from_near = shadow.clip_depth == ClipDepth::zero_to_one ? ndc.z : (ndc.z + 1) / 2;
    const Vec3 mapped = in_map(shadow, point);
    ASSERT_NEAR(double(mapped.x), double((ndc.x + 1) / 2), 1e-12);
    ASSERT_NEAR(double(mapped.y), double((ndc.y + 1) / 2), 1e-12);
    ASSERT_NEAR(double(mapped.z), double(shadow.reversed_z ? 1 - from_near : from_near), 1e-11);
    ASSERT_NEAR(double(clip.w), double(depth), 1e-11);
  });
}

TEST(SpotShadow, StoredDepthComesBackAsMetres) {
  for_random_maps([](const SpotShadow& shadow, SetupGenerator& generator) {
    const double depth = generator.uniform(shadow.light.shadow_near_plane_metres, shadow.light.range_metres);
    const double stored = shadow.stored_depth(depth);
    ASSERT_NEAR(stored, double(in_map(shadow, point_of(shadow, depth, 0.3L, -0.2L)).z), 1e-11);
    ASSERT_NEAR(shadow.axial_depth(stored), depth,
                1e-9 * depth * depth / shadow.light.shadow_near_plane_metres);
    ASSERT_NEAR(shadow.stored_depth(shadow.light.shadow_near_plane_metres), shadow.reversed_z ? 1.0 : 0.0,
                1e-12);
    ASSERT_NEAR(shadow.stored_depth(shadow.light.range_metres), shadow.reversed_z ? 0.0 : 1.0, 1e-12);
  });
}

// The lines lead from both ends of the source over an edge on the axis, to the receiver's plane.
TEST(SpotShadow, PenumbraIsThatOfSimilarTriangles) {
  for_random_maps([](const SpotShadow& shadow, SetupGenerator& generator) {
    const Real receiver =
        generator.uniform(2 * shadow.light.shadow_near_plane_metres, shadow.light.range_metres);
    const Real blocker = generator.uniform(shadow.light.shadow_near_plane_metres, double(receiver));
    const Real radius = shadow.light.source_radius_metres;
    const auto over_edge = [&](Real from) { return from + (0 - from) * receiver / blocker; };
    const Real width = std::abs(over_edge(radius) - over_edge(-radius));
    const double metres = penumbra_radius_metres(shadow.light, double(receiver), double(blocker));
    ASSERT_NEAR(2.0 * metres, double(width), 1e-12 * (1.0 + double(width)));
    // The map gives the same radius from the two depths it stores.
    const double gap = std::abs(shadow.stored_depth(double(receiver)) - shadow.stored_depth(double(blocker)));
    const Vec3 centre = point_of(shadow, receiver, 0, 0);
    const Vec3 right(shadow.view[0][0], shadow.view[1][0], shadow.view[2][0]);
    const Real uv = in_map(shadow, centre + width / 2 * right).x - in_map(shadow, centre).x;
    ASSERT_NEAR(gap * shadow.depth_to_radial, double(uv), 1e-9 * double(uv) + 1e-12);
    ASSERT_NEAR(shadow.radial_to_depth.value() * shadow.depth_to_radial, 1.0, 1e-12);
  });
}

TEST(SpotShadow, APointSourceHasNoPenumbra) {
  SpotLight light;
  light.source_radius_metres = 0.0;
  const SpotShadow shadow = spot_shadow(light, {});
  EXPECT_EQ(shadow.depth_to_radial, 0.0);
  EXPECT_FALSE(shadow.radial_to_depth);
  EXPECT_EQ(penumbra_radius_metres(light, 3.0, 1.0), 0.0);
}

// At 90 degrees the far plane's half width is the range, so the bias is 8 m / 1024 texels * 2.5.
TEST(SpotShadow, BiasIsUrps) {
  SpotLight light;
  light.outer_angle_degrees = 90.0;
  light.shadow_guard_degrees = 10.0;  // URP has no guard angle
  light.range_metres = 8.0;
  ShadowSettings settings;
  settings.resolution = 1024;
  settings.depth_bias = 2.0;
  settings.normal_bias = 3.0;
  const SpotShadow shadow = spot_shadow(light, settings);
  EXPECT_NEAR(shadow.depth_bias_metres, -2.0 * 2.5 * 8.0 / 1024.0, 1e-15);
  EXPECT_NEAR(shadow.normal_bias_metres, -3.0 * 2.5 * 8.0 / 1024.0, 1e-15);
}

TEST(SpotShadow, WhatIsOutOfRangeIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, std::function<void(SpotLight&, ShadowSettings&)>>> changes{
      {"position is nan", [=](auto& light, auto&) { light.position.y = nan; }},
      {"direction is zero or not finite", [](auto& light, auto&) { light.direction = glm::dvec3(0.0); }},
      {"direction is zero or not finite", [=](auto& light, auto&) { light.direction.x = nan; }},
      {"outer angle is 180, outside 1 .. 179 degrees",
       [](auto& light, auto&) { light.outer_angle_degrees = 180; }},
      {"inner angle is 31, outside 0 .. 30 degrees",
       [](auto& light, auto&) { light.inner_angle_degrees = 31; }},
      {"guard angle is 150, outside 0 .. 149", [](auto& light, auto&) { light.shadow_guard_degrees = 150; }},
      {"source radius is -1", [](auto& light, auto&) { light.source_radius_metres = -1; }},
      {"source radius is 11, outside 0 .. 10 m", [](auto& light, auto&) { light.source_radius_metres = 11; }},
      {"range is nan", [=](auto& light, auto&) { light.range_metres = nan; }},
      {"shadow near plane is 0", [](auto& light, auto&) { light.shadow_near_plane_metres = 0; }},
      {"near plane is at 10 m, not closer", [](auto& light, auto&) { light.shadow_near_plane_metres = 10; }},
      {"shadows/resolution is 4, outside 8 .. 16384", [](auto&, auto& settings) { settings.resolution = 4; }},
      {"shadows/depth_bias is -1", [](auto&, auto& settings) { settings.depth_bias = -1; }},
      {"shadows/normal_bias is nan", [=](auto&, auto& settings) { settings.normal_bias = nan; }},
  };
  for (const auto& [problem, change] : changes) {
    SpotLight light;
    ShadowSettings settings;
    change(light, settings);
    const auto refused = [&] { spot_shadow(light, settings); };
    EXPECT_THAT(refused, testing::ThrowsMessage<InputError>(HasSubstr(problem)));
  }
}

}  // namespace
}  // namespace penumbra::parameters
