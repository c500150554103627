// Tests properties of the fit, over random set-ups, that any reader of the atlas relies on.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "parameters/cascades.h"
#include "parameters/random_setup.h"

namespace penumbra::parameters {
namespace {

constexpr int kSetups = 300;

glm::dvec3 to_atlas(const Cascade& cascade, const glm::dvec3& world) {
  return glm::dvec3(cascade.world_to_shadow * glm::dvec4(world, 1.0));
}

// The coordinates in the tile, 0 .. 1 inside the tile.
glm::dvec2 to_tile(const Cascade& cascade, const glm::dvec3& world) {
  const glm::dvec3 atlas = to_atlas(cascade, world);
  return {(atlas.x - cascade.offset_scale.x) / cascade.offset_scale.z,
          (atlas.y - cascade.offset_scale.y) / cascade.offset_scale.w};
}

struct Split {
  double begin;
  double end;
};

Split split_of(const ShadowSetup& setup, int cascade) {
  const auto splits = effective_splits(setup.shadows);
  const double distance = std::min(setup.shadows.distance_metres, setup.camera.far_plane);
  return {cascade == 0 ? setup.camera.near_plane : splits[static_cast<std::size_t>(cascade - 1)] * distance,
          cascade + 1 == setup.shadows.cascades ? distance
                                                : splits[static_cast<std::size_t>(cascade)] * distance};
}

std::vector<glm::dvec3> sub_frustum_corners(const Camera& camera, const Split& split) {
  const glm::dvec3 forward = glm::normalize(camera.forward);
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, forward));
  const glm::dvec3 up = glm::cross(forward, right);
  const double tan_y = std::tan(camera.fov_y_degrees * std::numbers::pi / 360.0);
  std::vector<glm::dvec3> corners;
  for (const double distance : {split.begin, split.end}) {
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        corners.push_back(camera.position +
                          distance * (forward + right * (x * tan_y * camera.aspect) + up * (y * tan_y)));
      }
    }
  }
  return corners;
}

TEST(CascadeFit, SphereHoldsEveryCornerAndTouchesTheFarOnes) {
  SetupGenerator generator(1);
  for (int i = 0; i < kSetups; ++i) {
    const ShadowSetup setup = generator.next();
    for (const Cascade& cascade : setup.fit().cascades) {
      const glm::dvec3 centre(cascade.split_sphere);
      const double radius = cascade.split_sphere.w;
      double farthest = 0.0;
      for (const glm::dvec3& corner : sub_frustum_corners(setup.camera, split_of(setup, cascade.index))) {
        farthest = std::max(farthest, glm::distance(corner, centre));
      }
      EXPECT_NEAR(farthest, radius, 1e-9 * radius);
    }
  }
}

// No smaller sphere holds the corners: moving the centre along the axis either way loses one of them.
TEST(CascadeFit, SphereIsTheSmallest) {
  SetupGenerator generator(2);
  for (int i = 0; i < kSetups; ++i) {
    const ShadowSetup setup = generator.next();
    for (const Cascade& cascade : setup.fit().cascades) {
      for (const double step : {-1e-3, 1e-3}) {
        const glm::dvec3 moved = glm::dvec3(cascade.split_sphere) +
                                 glm::normalize(setup.camera.forward) * (step * cascade.split_sphere.w);
        double farthest = 0.0;
        for (const glm::dvec3& corner : sub_frustum_corners(setup.camera, split_of(setup, cascade.index))) {
          farthest = std::max(farthest, glm::distance(corner, moved));
        }
        EXPECT_GT(farthest, cascade.split_sphere.w);
      }
    }
  }
}

TEST(CascadeFit, RadiusAndTexelDoNotChangeWhenTheCameraTurnsOrMoves) {
  SetupGenerator generator(3);
  for (int i = 0; i < kSetups; ++i) {
    ShadowSetup setup = generator.next();
    const CascadeSet before = setup.fit();
    setup.camera.forward = generator.direction();
    setup.camera.up = glm::cross(setup.camera.forward, generator.direction());
    setup.camera.position += glm::dvec3(generator.uniform(-9, 9), 1, 2);
    const CascadeSet after = setup.fit();
    for (std::size_t c = 0; c < before.cascades.size(); ++c) {
      EXPECT_EQ(before.cascades[c].split_sphere.w, after.cascades[c].split_sphere.w);
      EXPECT_EQ(before.cascades[c].projection[0][0], after.cascades[c].projection[0][0]);
    }
  }
}

// A fixed world point moves across the map by whole texels, or not at all, however the camera moves.
TEST(CascadeFit, MovingCameraMovesTheMapByWholeTexels) {
  SetupGenerator generator(4);
  int moved = 0;
  for (int i = 0; i < kSetups; ++i) {
    ShadowSetup setup = generator.next();
    const CascadeSet before = setup.fit();
    const double texel = before.cascades.front().texel_size_metres;
    setup.camera.position += generator.direction() * texel * generator.uniform(0.0, 3.0);
    const CascadeSet after = setup.fit();
    for (std::size_t c = 0; c < before.cascades.size(); ++c) {
      const glm::dvec2 step =
          (to_tile(after.cascades[c], {1, 2, 3}) - to_tile(before.cascades[c], {1, 2, 3})) *
          static_cast<double>(before.tile_resolution);
      for (const double texels : {step.x, step.y}) {
        EXPECT_NEAR(texels, std::round(texels), 1e-6);
        moved += std::abs(texels) > 0.5 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(moved, kSetups / 4);  // the camera did move the map
}

TEST(CascadeFit, TileHoldsTheWholeSphere) {
  SetupGenerator generator(5);
  for (int i = 0; i < kSetups; ++i) {
    const ShadowSetup setup = generator.next();
    for (const Cascade& cascade : setup.fit().cascades) {
      for (int k = 0; k < 16; ++k) {
        const glm::dvec3 point =
            glm::dvec3(cascade.split_sphere) + generator.direction() * cascade.split_sphere.w;
        const glm::dvec2 tile = to_tile(cascade, point);
        EXPECT_TRUE(tile.x >= 0.0 && tile.x <= 1.0 && tile.y >= 0.0 && tile.y <= 1.0)
            << tile.x << " " << tile.y;
      }
    }
  }
}

TEST(CascadeFit, DepthGrowsAlongTheLightOrAgainstItWhenReversed) {
  SetupGenerator generator(6);
  for (int i = 0; i < kSetups; ++i) {
    const ShadowSetup setup = generator.next();
    const CascadeSet set = setup.fit();
    for (const Cascade& cascade : set.cascades) {
      const glm::dvec3 centre(cascade.split_sphere);
      const double nearer = to_atlas(cascade, centre - set.light_direction).z;
      const double farther = to_atlas(cascade, centre + set.light_direction).z;
      EXPECT_NEAR(farther - nearer, (set.reversed_z ? -2.0 : 2.0) * cascade.depth_per_metre, 1e-9);
      EXPECT_GT(to_atlas(cascade, centre).z, 0.0);
      EXPECT_LT(to_atlas(cascade, centre).z, 1.0);
    }
  }
}

// This is the end of it all: a blocker `gap` metres above the receiver along the light has a penumbra of
// radius tan(a / 2) gap metres, and depth_to_radial turns the stored depth gap into just that, in tile UV.
TEST(CascadeFit, DepthToRadialTurnsADepthGapIntoThePenumbrasRadius) {
  SetupGenerator generator(7);
  for (int i = 0; i < kSetups; ++i) {
    const ShadowSetup setup = generator.next();
    const CascadeSet set = setup.fit();
    const double tan_half = std::tan(setup.light.angular_diameter_degrees * std::numbers::pi / 360.0);
    for (const Cascade& cascade : set.cascades) {
      const glm::dvec3 receiver(cascade.split_sphere);
      const double gap = generator.uniform(0.01, 5.0);
      const double dz =
          std::abs(to_atlas(cascade, receiver).z - to_atlas(cascade, receiver - set.light_direction * gap).z);
      const glm::dvec3 across = glm::normalize(glm::cross(set.light_direction, generator.direction()));
      const double uv =
          glm::distance(to_tile(cascade, receiver), to_tile(cascade, receiver + across * (tan_half * gap)));
      EXPECT_NEAR(dz * cascade.depth_to_radial, uv, 1e-9);
      EXPECT_NEAR(uv * *cascade.radial_to_depth, dz, 1e-9);
      EXPECT_NEAR(uv / (tan_half * gap), cascade.uv_per_metre, 1e-7 * cascade.uv_per_metre);
      EXPECT_EQ(cascade.depth_to_radial_hdrp, 2.0 * cascade.depth_to_radial);
      EXPECT_NEAR(cascade.max_penumbra_texels * cascade.texel_size_metres, tan_half / cascade.depth_per_metre,
                  1e-9 * tan_half / cascade.depth_per_metre);
    }
  }
}

// HDRP's form is read off the emitted projections: a 0 .. 1 projection has twice the geometric figure, a -1
// .. 1 projection the geometric figure itself.
TEST(CascadeFit, HdrpFormIsTwiceTheGeometricOneForDeviceDepthOnly) {
  SetupGenerator generator(8);
  for (int i = 0; i < kSetups; ++i) {
    const ShadowSetup setup = generator.next();
    const CascadeSet set = setup.fit();
    const double tan_half = std::tan(setup.light.angular_diameter_degrees * std::numbers::pi / 360.0);
    for (const Cascade& cascade : set.cascades) {
      const double ratio = std::abs(tan_half * cascade.projection[0][0] / cascade.projection[2][2]);
      const bool device = set.clip_depth == ClipDepth::zero_to_one;
      const double expected = device ? cascade.depth_to_radial_hdrp : cascade.depth_to_radial;
      EXPECT_NEAR(ratio, expected, 1e-12 * expected);
    }
  }
}

TEST(CascadeFit, PointLightHasNoInverse) {
  const CascadeSet set = fit_cascades({}, {.angular_diameter_degrees = 0.0}, {});
  EXPECT_EQ(set.cascades[0].depth_to_radial, 0.0);
  EXPECT_FALSE(set.cascades[0].radial_to_depth.has_value());
}

// The matrix is that of GetShadowTransform and ApplySliceTransform, as a product of matrices.
TEST(CascadeFit, ShadowMatrixIsUrpsProduct) {
  SetupGenerator generator(9);
  for (int i = 0; i < kSetups; ++i) {
    const ShadowSetup setup = generator.next();
    const CascadeSet set = setup.fit();
    for (const Cascade& cascade : set.cascades) {
      glm::dmat4 clip = cascade.projection;
      if (set.clip_depth == ClipDepth::zero_to_one) {
        for (int c = 0; c < 4; ++c) clip[c][2] = 2.0 * clip[c][2] - (c == 3 ? 1.0 : 0.0);
      }
      if (set.reversed_z) {
        for (int c = 0; c < 4; ++c) clip[c][2] *= -1.0;
      }
      glm::dmat4 bias(0.5);
      bias[3] = {0.5, 0.5, 0.5, 1.0};
      glm::dmat4 slice(1.0);
      slice[0][0] = cascade.offset_scale.z;
      slice[1][1] = cascade.offset_scale.w;
      slice[3] = {cascade.offset_scale.x, cascade.offset_scale.y, 0.0, 1.0};
      const glm::dmat4 product = slice * bias * clip * cascade.view;
      for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 4; ++r) {
          EXPECT_NEAR(product[c][r], cascade.world_to_shadow[c][r], 1e-11 * (1.0 + std::abs(product[c][r])));
        }
      }
    }
  }
}

TEST(CascadeFit, ViewLooksDownMinusZAsUnitys) {
  const CascadeSet set = fit_cascades({}, {.direction = {0.0, -1.0, 1.0}}, {});
  const glm::dmat4& view = set.cascades[0].view;
  // The world is left-handed, the view right-handed.
  EXPECT_NEAR(glm::determinant(glm::dmat3(view)), -1.0, 1e-12);
  const glm::dvec4 along = view * glm::dvec4(set.light_direction, 0.0);
  EXPECT_NEAR(along.z, -1.0, 1e-12);
}

struct AtlasCase {
  int cascades;
  int height;
  int tile;
  glm::dvec4 last_tile;
};

TEST(AtlasLayout, IsUrps) {
  const AtlasCase cases[] = {{1, 2048, 2048, {0, 0, 1, 1}},
                             {2, 1024, 1024, {0.5, 0, 0.5, 1}},
                             {3, 2048, 1024, {0, 0.5, 0.5, 0.5}},
                             {4, 2048, 1024, {0.5, 0.5, 0.5, 0.5}}};
  for (const AtlasCase& expected : cases) {
    const AtlasLayout layout = atlas_layout(2048, expected.cascades);
    EXPECT_EQ(layout.width, 2048);
    EXPECT_EQ(layout.height, expected.height);
    EXPECT_EQ(layout.tile_resolution, expected.tile);
    EXPECT_EQ(tile_rectangle(layout, expected.cascades - 1), expected.last_tile);
  }
}

TEST(UrpBias, GrowsWithTheKernelOfEachQuality) {
  const double radii[] = {1.0, 1.5, 2.5, 3.5};
  for (int quality = 0; quality < 4; ++quality) {
    ShadowSettings settings{.depth_bias = 2.0, .normal_bias = 0.5};
    settings.soft_quality = static_cast<SoftQuality>(quality);
    const Cascade cascade = fit_cascades({}, {}, settings).cascades[0];
    const double texel = 2.0 / cascade.projection[0][0] / 2048.0;
    EXPECT_NEAR(cascade.depth_bias_metres, -2.0 * texel * radii[quality], 1e-12);
    EXPECT_NEAR(cascade.normal_bias_metres, -0.5 * texel * radii[quality], 1e-12);
  }
}

TEST(EffectiveSplits, AreUrpsDefaultsUntilGiven) {
  EXPECT_EQ(effective_splits({.cascades = 2})[0], 0.25);
  EXPECT_EQ(effective_splits({.cascades = 3})[1], 0.3);
  EXPECT_EQ(effective_splits({.cascades = 4})[2], 0.467);
  EXPECT_EQ(effective_splits({.cascades = 2, .splits = {0.4, 0, 0}})[0], 0.4);
}

}  // namespace
}  // namespace penumbra::parameters
