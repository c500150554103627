// Compares the visibility of a spot light's source with the chord that an edge cuts from it, with the share
// that a disc covers, and with the sun's in the limit.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "input/input_error.h"
#include "reference/hand_built.h"
#include "reference/reference_cache.h"
#include "reference/scratch_folder.h"
#include "reference/trace_visibility.h"

namespace penumbra::reference {
namespace {

using hand_built::Setting;

constexpr double kReceiverDepth = 4.0;  // axial, metres
constexpr double kBlockerDepth = 2.5;

// A lamp over the centre of the setting, whose own frame is the light's: `at` counts from the receivers'
// plane.
struct Lamp {
  Setting setting;  // its light's diameter does not matter
  parameters::SpotLight light;

  explicit Lamp(double radius) {
    light.position = setting.at(0.0, 0.0, kReceiverDepth);
    light.direction = -2.0 * setting.disc().to_light;
    light.outer_angle_degrees = 80.0;
    light.source_radius_metres = radius;
  }
  static constexpr double blocker_height = kReceiverDepth - kBlockerDepth;
};

glm::dvec3 lifted(const scene::Receivers& receivers, std::size_t pixel) {
  const glm::vec3 position(receivers.position_relative[pixel]);
  return glm::dvec3(position) + surface_offset(position) * glm::dvec3(receivers.normal_ws[pixel]);
}

// The share that is seen past a straight edge: its plane through the receiver cuts the disc, which faces the
// receiver, along a chord.
double visible_past(const glm::dvec3& receiver, const parameters::SpotLight& light, const glm::dvec3& edge,
                    const glm::dvec3& along_edge, const glm::dvec3& open_side) {
  glm::dvec3 normal = glm::normalize(glm::cross(along_edge, edge - receiver));
  if (glm::dot(normal, open_side) < 0.0) normal = -normal;
  const glm::dvec3 to_centre = light.position - receiver;
  const double sine = glm::dot(normal, glm::normalize(to_centre));
  const double from_centre = glm::dot(normal, to_centre) / std::sqrt(1.0 - sine * sine);
  const double chord = glm::clamp(from_centre / light.source_radius_metres, -1.0, 1.0);
  return 0.5 + (chord * std::sqrt(1.0 - chord * chord) + std::asin(chord)) / std::numbers::pi;
}

TEST(SpotVisibility, StraightEdgeCutsAChordFromTheSource) {
  for (const double radius : {0.05, 0.4}) {
    for (const double aside : {0.0, -2.0, 1.5}) {  // distance from the axis, at the blocker
      Lamp lamp(radius);
      lamp.light.outer_angle_degrees = 120.0;
      scene::Scene scene;
      hand_built::add_rectangle(scene.mesh, lamp.setting, {aside - 40.0, aside, -40.0, 40.0},
                                Lamp::blocker_height);
      const double shadow = aside * kReceiverDepth / kBlockerDepth;
      const double width = parameters::penumbra_radius_metres(lamp.light, kReceiverDepth, kBlockerDepth) *
                           std::hypot(1.0, aside / kBlockerDepth);  // divided by the cosine to the axis
      const scene::Receivers receivers = hand_built::receivers(lamp.setting, {64, 4}, [&](int x, int y) {
        return glm::dvec2(shadow + 1.3 * width * (2.0 * (x + 0.5) / 64.0 - 1.0), 0.3 * y);
      });
      const VisibilityImage image = trace_visibility(scene, receivers, lamp.light);
      const DiscLight frame = lamp.setting.disc();
      double least = 1.0, most = 0.0;
      for (std::size_t pixel = 0; pixel < image.visibility.size(); ++pixel) {
        ASSERT_EQ(image.valid[pixel], 1);
        const double exact =
            visible_past(lifted(receivers, pixel), lamp.light,
                         lamp.setting.at(aside, 0.0, Lamp::blocker_height), frame.up, frame.right);
        EXPECT_NEAR(image.visibility[pixel], exact, 6.0 * image.noise_floor) << radius << ", pixel " << pixel;
        least = std::min(least, exact);
        most = std::max(most, exact);
      }
      EXPECT_LT(image.noise_floor, 0.005);
      EXPECT_EQ(least, 0.0) << "the penumbra is as wide as parameters say";
      EXPECT_EQ(most, 1.0);
    }
  }
}

TEST(SpotVisibility, ACircleCoversItsShareOfTheSource) {
  const Lamp lamp(0.3);
  const scene::Receivers at_centre =
      hand_built::receivers(lamp.setting, {16, 16}, [](int, int) { return glm::dvec2(0.0); });
  for (const double share : {0.3, 0.7, 0.95}) {
    scene::Scene scene;
    const double in_blockers_plane = lamp.light.source_radius_metres * Lamp::blocker_height / kReceiverDepth;
    hand_built::add_circle(scene.mesh, lamp.setting, share * in_blockers_plane, Lamp::blocker_height);
    const VisibilityImage image = trace_visibility(scene, at_centre, lamp.light);
    double mean = 0.0;
    for (const float visibility : image.visibility) mean += visibility / 256.0;
    EXPECT_NEAR(mean, 1.0 - share * share, 0.001) << share;
  }
}

// The rays are the same, and ever more parallel: from 100 m to 100 km.
TEST(SpotVisibility, FarAwayItIsTheSun) {
  const Setting setting;
  scene::Scene scene;
  hand_built::add_rectangle(scene.mesh, setting, {-40.0, 0.0, -40.0, 40.0}, 3.0);
  const double width = 3.0 * setting.tan_half();
  const scene::Receivers receivers = hand_built::receivers(setting, {64, 16}, [&](int x, int y) {
    return glm::dvec2(1.2 * width * (2.0 * (x + 0.5) / 64.0 - 1.0), 0.05 * y);
  });
  const VisibilityImage sun = trace_visibility(scene, receivers, setting.light);
  double last = 1.0;
  for (const double distance : {1e2, 1e3, 1e4, 1e5}) {
    parameters::SpotLight spot;
    spot.position = setting.at(0.0, 0.0, distance);
    spot.direction = setting.light.direction;
    spot.range_metres = 2.0 * distance;
    spot.source_radius_metres = distance * setting.tan_half();
    const VisibilityImage image = trace_visibility(scene, receivers, spot);
    ASSERT_EQ(image.valid, sun.valid);
    double difference = 0.0;
    for (std::size_t pixel = 0; pixel < sun.visibility.size(); ++pixel) {
      difference += std::abs(double(image.visibility[pixel]) - sun.visibility[pixel]);
    }
    difference /= static_cast<double>(sun.visibility.size());
    EXPECT_LT(difference, 0.5 * last) << distance << " m";
    last = difference;
  }
  EXPECT_LT(last, 1e-4);
}

TEST(SpotVisibility, WhatIsBehindTheSourceHidesNothing) {
  const Lamp lamp(0.2);
  const scene::Receivers receivers =
      hand_built::receivers(lamp.setting, {9, 9}, [](int x, int y) { return glm::dvec2(0.1 * x, 0.1 * y); });
  for (const double radius : {0.2, 0.0}) {
    parameters::SpotLight light = lamp.light;
    light.source_radius_metres = radius;
    scene::Scene scene;
    hand_built::add_rectangle(scene.mesh, lamp.setting, {-90, 90, -90, 90}, kReceiverDepth + 0.5);
    for (const float visibility : trace_visibility(scene, receivers, light).visibility)
      EXPECT_EQ(visibility, 1.0F);
    hand_built::add_rectangle(scene.mesh, lamp.setting, {-90, 90, -90, 90}, kReceiverDepth - 0.5);
    for (const float visibility : trace_visibility(scene, receivers, light).visibility)
      EXPECT_EQ(visibility, 0.0F);
  }
}

TEST(SpotVisibility, APointIsAllOrNothingByOneRay) {
  const Lamp lamp(0.0);
  scene::Scene scene;
  hand_built::add_rectangle(scene.mesh, lamp.setting, {-9.0, 0.0, -9.0, 9.0}, Lamp::blocker_height);
  const scene::Receivers receivers = hand_built::receivers(
      lamp.setting, {20, 1}, [](int x, int) { return glm::dvec2(0.01 * (x - 10) + 0.005, 0.0); });
  double rays = 0.0;
  RunOptions run;
  run.progress = [&](double, double total) { rays = total; };
  const VisibilityImage image = trace_visibility(scene, receivers, lamp.light, {}, run);
  for (int x = 0; x < 20; ++x) EXPECT_EQ(image.visibility[static_cast<std::size_t>(x)], x < 10 ? 0.0F : 1.0F);
  EXPECT_EQ(rays, 20.0);
}

TEST(SpotVisibility, ReceiversAreInTheConeWithinRangeAndSeeAllOfTheSource) {
  Lamp lamp(0.2);
  lamp.light.range_metres = 4.5;
  const double edge = kReceiverDepth * std::tan(glm::radians(40.0)), reach = std::sqrt(4.5 * 4.5 - 16.0);
  scene::Receivers receivers = hand_built::receivers(lamp.setting, {9, 1}, [&](int x, int) {
    const double places[] = {0.0, reach - 0.001, reach + 0.001, 0.0,         0.0,
                             0.0, 0.0,           edge - 0.001,  edge + 0.001};
    return glm::dvec2(places[x], 0.0);
  });
  const DiscLight frame = lamp.setting.disc();
  const auto tilted = [&](double degrees_above_horizon) {
    const double angle = glm::radians(degrees_above_horizon);
    return glm::vec4(glm::vec3(std::cos(angle) * frame.right + std::sin(angle) * frame.to_light), 0.0F);
  };
  const double half = glm::degrees(std::atan(0.2 / kReceiverDepth));
  receivers.normal_ws[3] = tilted(half - 0.01);
  receivers.normal_ws[4] = tilted(half + 0.01);
  receivers.position_relative[5] = glm::vec4(glm::vec3(lamp.setting.at(0, 0, kReceiverDepth - 0.15)), 1.0F);
  receivers.position_relative[6] = glm::vec4(glm::vec3(lamp.setting.at(0, 0, kReceiverDepth - 0.25)), 1.0F);
  const scene::Scene scene;
  EXPECT_EQ(trace_visibility(scene, receivers, lamp.light).valid,
            (std::vector<std::uint8_t>{1, 1, 0, 0, 1, 0, 1, 0, 0}));
  lamp.light.range_metres = 40.0;
  EXPECT_EQ(trace_visibility(scene, receivers, lamp.light).valid,
            (std::vector<std::uint8_t>{1, 1, 1, 0, 1, 0, 1, 1, 0}));
}

TEST(SpotVisibility, FalloffIsNoPartOfItAndAnswersAreKeptByTheLight) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  Lamp lamp(0.3);
  scene::Scene scene;
  hand_built::add_rectangle(scene.mesh, lamp.setting, {-9.0, 0.0, -9.0, 9.0}, Lamp::blocker_height);
  const scene::Receivers receivers = hand_built::receivers(
      lamp.setting, {32, 1}, [](int x, int) { return glm::dvec2(0.02 * (x - 16), 0.0); });
  const auto traced = [&] { return trace_visibility(scene, receivers, lamp.light, {}, {}, &cache); };
  const VisibilityImage image = traced();
  EXPECT_EQ(traced(), image);
  lamp.light.inner_angle_degrees = 1.0;
  EXPECT_EQ(trace_visibility(scene, receivers, lamp.light), image);
  const std::vector<std::function<void(parameters::SpotLight&)>> changes{
      [](auto& light) { light.position.y += 0.1; }, [](auto& light) { light.source_radius_metres = 0.2; },
      [](auto& light) { light.range_metres = 4.001; }, [](auto& light) { light.outer_angle_degrees = 2.0; },
      [](auto& light) { light.direction.x += 3.0; }};
  const parameters::SpotLight before = lamp.light;
  for (const auto& change : changes) {
    lamp.light = before;
    lamp.light.inner_angle_degrees = 0.0;
    change(lamp.light);
    EXPECT_NE(traced(), image);
  }
}

TEST(SpotVisibility, BadLightsAreRefused) {
  Lamp lamp(0.3);
  lamp.light.outer_angle_degrees = 200.0;
  const scene::Receivers receivers =
      hand_built::receivers(lamp.setting, {1, 1}, [](int, int) { return glm::dvec2(0.0); });
  EXPECT_THROW(trace_visibility({}, receivers, lamp.light), InputError);
}

}  // namespace
}  // namespace penumbra::reference
