// Tests tiles fitted to receivers: each receiver and what a filter reads for it is in its tile, no smaller
// size would do, and small motions move the map by whole texels.
#include "parameters/receiver_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "input/input_error.h"
#include "parameters/random_setup.h"

namespace penumbra::parameters {
namespace {

constexpr int kFitSetups = 60;
constexpr int kFitReceivers = 300;
constexpr std::array kReceiverFits{LightFit::receivers, LightFit::turned_receivers,
                                   LightFit::turned_receivers_range};

// The receivers are on a ground plane, and now and then on a wall, as far as the camera sees and shadows
// reach.
std::vector<glm::dvec3> receivers_of(const ShadowSetup& setup, SetupGenerator& generator) {
  const Camera& camera = setup.camera;
  const glm::dvec3 forward = glm::normalize(camera.forward);
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, forward));
  const glm::dvec3 up = glm::cross(forward, right);
  const double tan_y = std::tan(camera.fov_y_degrees * std::numbers::pi / 360.0);
  const double distance = std::min(setup.shadows.distance_metres, camera.far_plane);
  const double middle = generator.uniform(camera.near_plane, distance);
  std::vector<glm::dvec3> receivers;
  while (receivers.size() < kFitReceivers) {
    const double depth =
        middle + (distance - middle) * generator.uniform(0.0, 1.0) * generator.uniform(0.0, 1.0);
    receivers.push_back(camera.position +
                        depth * (forward + right * (tan_y * camera.aspect * generator.uniform(-1, 1)) +
                                 up * (tan_y * generator.uniform(-1.0, -0.5))));
  }
  return receivers;
}

// The cascade that a shader selects.
const Cascade* cascade_of(const CascadeSet& set, const glm::dvec3& receiver) {
  for (const Cascade& cascade : set.cascades)
    if (glm::distance(glm::dvec3(cascade.split_sphere), receiver) < cascade.split_sphere.w) return &cascade;
  return nullptr;
}

// The tile UV and the stored depth.
glm::dvec3 in_tile(const Cascade& cascade, const glm::dvec3& world) {
  const glm::dvec3 atlas(cascade.world_to_shadow * glm::dvec4(world, 1.0));
  const glm::dvec4& tile = cascade.offset_scale;
  return {(atlas.x - tile.x) / tile.z, (atlas.y - tile.y) / tile.w, atlas.z};
}

// The part of the map that lies between the receiver and its nearest possible caster.
double largest_gap(const CascadeSet& set, double stored) {
  return set.reversed_z ? 1.0 - stored : stored;
}

bool has_sphere_tile(const Cascade& cascade, const CascadeSet& spheres) {
  return cascade.texel_size_metres ==
         spheres.cascades[static_cast<std::size_t>(cascade.index)].texel_size_metres;
}

TEST(ReceiverFit, EveryReceiverAndItsKernelAreInTheTile) {
  SetupGenerator generator(21);
  int tightened = 0;
  for (int i = 0; i < kFitSetups; ++i) {
    ShadowSetup setup = generator.next();
    setup.shadows.depth_range_metres.reset();
    setup.light.angular_diameter_degrees = generator.uniform(0.0, 2.0);
    const std::vector<glm::dvec3> receivers = receivers_of(setup, generator);
    const CascadeSet spheres = setup.fit();
    for (const LightFit fit : kReceiverFits) {
      const CascadeSet set = fit_cascades(setup.camera, setup.light, setup.shadows, fit, receivers);
      for (const glm::dvec3& receiver : receivers) {
        const Cascade* cascade = cascade_of(set, receiver);
        if (cascade == nullptr) continue;
        const glm::dvec3 at = in_tile(*cascade, receiver);
        EXPECT_GT(at.z, 0.0) << name_of(fit);
        EXPECT_LT(at.z, 1.0) << name_of(fit);
        double margin = 0.0;
        if (fit != LightFit::turned_receivers_range && !has_sphere_tile(*cascade, spheres)) {
          margin =
              cascade->depth_to_radial * largest_gap(set, at.z) + kKernelMarginTexels / set.tile_resolution;
          ++tightened;
        }
        for (const double uv : {at.x, at.y}) {
          EXPECT_GE(uv, margin - 1e-9) << name_of(fit) << ", cascade " << cascade->index;
          EXPECT_LE(uv, 1.0 - margin + 1e-9) << name_of(fit) << ", cascade " << cascade->index;
        }
      }
    }
  }
  EXPECT_GT(tightened, kFitSetups * kFitReceivers / 2) << "receivers in tiles that are not their spheres'";
}

TEST(ReceiverFit, NoTileIsLargerThanItsSpheres) {
  SetupGenerator generator(22);
  double gain = 0.0;
  int tiles = 0;
  for (int i = 0; i < kFitSetups; ++i) {
    const ShadowSetup setup = generator.next();
    const std::vector<glm::dvec3> receivers = receivers_of(setup, generator);
    const CascadeSet spheres = setup.fit();
    const CascadeSet straight =
        fit_cascades(setup.camera, setup.light, setup.shadows, LightFit::receivers, receivers);
    const CascadeSet turned =
        fit_cascades(setup.camera, setup.light, setup.shadows, LightFit::turned_receivers, receivers);
    for (std::size_t c = 0; c < spheres.cascades.size(); ++c) {
      // The kernel's margin is in texels of the new tile.
      const double margin = 1.0 + 6.0 / spheres.tile_resolution;
      EXPECT_LE(straight.cascades[c].texel_size_metres, margin * spheres.cascades[c].texel_size_metres);
      EXPECT_LE(turned.cascades[c].texel_size_metres, straight.cascades[c].texel_size_metres);
      EXPECT_EQ(turned.cascades[c].split_sphere, spheres.cascades[c].split_sphere);
      gain += spheres.cascades[c].texel_size_metres / straight.cascades[c].texel_size_metres;
      ++tiles;
    }
  }
  EXPECT_GT(gain / tiles, 1.2) << "mean gain";
}

// The check is in long double, from the positions: the next smaller size does not hold them.
TEST(ReceiverFit, TheSizeIsTheSmallestOfItsSteps) {
  SetupGenerator generator(23);
  int checked = 0;
  for (int i = 0; i < kFitSetups; ++i) {
    const ShadowSetup setup = generator.next();
    const std::vector<glm::dvec3> receivers = receivers_of(setup, generator);
    const CascadeSet spheres = setup.fit();
    const CascadeSet set =
        fit_cascades(setup.camera, setup.light, setup.shadows, LightFit::receivers, receivers);
    for (const Cascade& cascade : set.cascades) {
      if (has_sphere_tile(cascade, spheres)) continue;
      const long double margin = kSnapMarginTexels + kKernelMarginTexels;
      const long double half =
          static_cast<long double>(cascade.texel_size_metres) * (set.tile_resolution / 2.0L - margin);
      const long double steps = std::log2(half) * kSizesPerOctave;
      EXPECT_NEAR(static_cast<double>(steps), std::round(static_cast<double>(steps)), 1e-6);
      if (half < cascade.split_sphere.w / 60.0L) continue;  // no size is smaller
      const glm::dmat4& m = cascade.view;
      long double low[2]{HUGE_VALL, HUGE_VALL}, high[2]{-HUGE_VALL, -HUGE_VALL};
      for (const glm::dvec3& receiver : receivers) {
        if (cascade_of(set, receiver) != &cascade) continue;
        const long double gap = static_cast<long double>(largest_gap(set, in_tile(cascade, receiver).z)) /
                                cascade.depth_per_metre;
        const long double radius =
            std::tan(setup.light.angular_diameter_degrees * std::numbers::pi_v<long double> / 360) *
            std::max(gap, 0.0L);
        for (int axis = 0; axis < 2; ++axis) {
          const long double at = static_cast<long double>(m[0][axis]) * receiver.x +
                                 static_cast<long double>(m[1][axis]) * receiver.y +
                                 static_cast<long double>(m[2][axis]) * receiver.z;
          low[axis] = std::min(low[axis], at - radius);
          high[axis] = std::max(high[axis], at + radius);
        }
      }
      const long double needed = std::max(high[0] - low[0], high[1] - low[1]) / 2;
      EXPECT_GE(half, needed * (1 - 1e-9L));
      // Receivers at the rim of a sphere may count to two cascades.
      EXPECT_LE(half / std::exp2(1.0L / kSizesPerOctave), needed * 1.001L + 1e-3L * cascade.split_sphere.w);
      ++checked;
    }
  }
  EXPECT_GT(checked, kFitSetups);
}

TEST(ReceiverFit, MovesTheMapByWholeTexelsWhileItsSizeStays) {
  SetupGenerator generator(24);
  int moved = 0;
  for (int i = 0; i < kFitSetups; ++i) {
    const ShadowSetup setup = generator.next();
    const std::vector<glm::dvec3> receivers = receivers_of(setup, generator);
    const CascadeSet before =
        fit_cascades(setup.camera, setup.light, setup.shadows, LightFit::receivers, receivers);
    ShadowSetup later = setup;
    const glm::dvec3 step = generator.direction() * before.cascades.front().texel_size_metres * 2.5;
    later.camera.position += step;
    std::vector<glm::dvec3> seen = receivers;
    for (glm::dvec3& receiver : seen) receiver += step;
    const CascadeSet after =
        fit_cascades(later.camera, later.light, later.shadows, LightFit::receivers, seen);
    for (std::size_t c = 0; c < before.cascades.size(); ++c) {
      if (before.cascades[c].texel_size_metres != after.cascades[c].texel_size_metres) continue;
      const glm::dvec3 by = (in_tile(after.cascades[c], {1, 2, 3}) - in_tile(before.cascades[c], {1, 2, 3})) *
                            static_cast<double>(before.tile_resolution);
      for (const double texels : {by.x, by.y}) {
        EXPECT_NEAR(texels, std::round(texels), 1e-6);
        moved += std::abs(texels) > 0.5 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(moved, kFitSetups / 4);
}

TEST(ReceiverFit, SplitsDivideTheDepthsThatAreSeen) {
  const ShadowSettings settings{.cascades = 4};
  std::vector<glm::dvec3> receivers;
  for (int i = 0; i <= 20; ++i) receivers.emplace_back(i % 3 - 1.0, 0.0, 5.0 + 0.5 * i);
  const CascadeSet all = fit_cascades({}, {}, settings, LightFit::turned_receivers, receivers);
  const CascadeSet seen = fit_cascades({}, {}, settings, LightFit::turned_receivers_range, receivers);
  EXPECT_EQ(cascade_of(seen, receivers.front()), &seen.cascades.front());
  for (const glm::dvec3& receiver : receivers) EXPECT_NE(cascade_of(seen, receiver), nullptr);
  EXPECT_LT(seen.cascades.back().split_sphere.w, 0.5 * all.cascades.back().split_sphere.w);
}

TEST(ReceiverFit, WithoutReceiversIsTheSphereFit) {
  SetupGenerator generator(25);
  for (int i = 0; i < kFitSetups; ++i) {
    const ShadowSetup setup = generator.next();
    const CascadeSet spheres = setup.fit();
    for (const LightFit fit : kReceiverFits) {
      const CascadeSet set = fit_cascades(setup.camera, setup.light, setup.shadows, fit, {});
      for (std::size_t c = 0; c < spheres.cascades.size(); ++c)
        EXPECT_EQ(set.cascades[c].world_to_shadow, spheres.cascades[c].world_to_shadow);
    }
  }
}

TEST(ReceiverFit, OneReceiverAloneKeepsATileOfSomeSize) {
  const std::vector<glm::dvec3> alone{{0.0, 1.0, 3.0}};
  for (const LightFit fit : kReceiverFits) {
    const CascadeSet set = fit_cascades({}, {.angular_diameter_degrees = 0.0}, {}, fit, alone);
    const double side = set.cascades[0].texel_size_metres * set.tile_resolution;
    EXPECT_GE(side, 2.0 * set.cascades[0].split_sphere.w / 64.0);
    EXPECT_LE(side, 2.0 * set.cascades[0].split_sphere.w / 50.0);
  }
}

TEST(ReceiverFit, RefusesPositionsThatAreNotFinite) {
  const std::vector<glm::dvec3> receivers{{0.0, 0.0, 5.0},
                                          {0.0, std::numeric_limits<double>::quiet_NaN(), 5.0}};
  EXPECT_THROW(fit_cascades({}, {}, {}, LightFit::receivers, receivers), InputError);
}

TEST(ReceiverFit, CastersIsTheFitToTheirBounds) {
  const Bounds bounds{{-2, 0, 8}, {2, 3, 12}};
  const ShadowSettings loose{.caster_bounds = bounds};
  ShadowSettings tight = loose;
  tight.fit_to_bounds = true;
  EXPECT_EQ(fit_cascades({}, {}, loose, LightFit::casters, {}).cascades[0].world_to_shadow,
            fit_cascades({}, {}, tight).cascades[0].world_to_shadow);
}

}  // namespace
}  // namespace penumbra::parameters
