// Compares the rasterised cascade atlas with closed forms of planes.
#include <cmath>
#include <cstring>
#include <glm/matrix.hpp>

#include "input/input_error.h"
#include "scene/frame_scene.h"

namespace penumbra::scene {
namespace {

struct Plane {
  glm::dvec3 normal;  // unit
  double offset;      // normal . p = offset, world space
};

// The depth that the map must hold at an atlas UV that looks at the plane.
double stored_depth(const parameters::Cascade& cascade, const glm::dvec2& uv, const Plane& plane) {
  const glm::dmat4 to_world = glm::inverse(cascade.world_to_shadow);
  const glm::dvec3 start(to_world * glm::dvec4(uv, 0.0, 1.0));
  const glm::dvec3 end(to_world * glm::dvec4(uv, 1.0, 1.0));
  return (plane.offset - glm::dot(plane.normal, start)) / glm::dot(plane.normal, end - start);
}

struct MapError {
  std::size_t texels = 0;      // compared
  std::size_t missing = 0;     // the plane is in the tile's depth range and the map is clear
  double worst = 0.0;          // largest |stored - analytic|
  double worst_allowed = 0.0;  // largest |stored - analytic| as a share of what is allowed
};

// The allowed error is half a step of the format; vertices snapped to 1/256 texel, which tilts the depth by
// as much of its gradient (Vulkan's least subPixelPrecisionBits is 4, this device has 8); and the float's
// rounding of three products and sums per coordinate, a step each, for vertex and interpolation.
MapError compare(const Frame& frame, const parameters::Cascade& cascade, const Plane& plane) {
  const ShadowAtlas& atlas = frame.atlas;
  const glm::dvec2 size(atlas.width, atlas.height);
  const glm::dvec2 texel = 1.0 / size;
  const glm::dvec2 begin = glm::dvec2(cascade.offset_scale) * size;
  const int side = frame.cascades.tile_resolution;
  const glm::dvec2 middle = (begin + 0.5 * side) * texel;
  const double here = stored_depth(cascade, middle, plane);
  const double gradient = std::abs(stored_depth(cascade, middle + glm::dvec2(texel.x, 0), plane) - here) +
                          std::abs(stored_depth(cascade, middle + glm::dvec2(0, texel.y), plane) - here);
  const double allowed =
      0.5 * format_step(frame.settings.format) + gradient / 256.0 + 16.0 * std::ldexp(1.0, -24);
  MapError error;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int column = static_cast<int>(std::lround(begin.x)) + x;
      const int row = static_cast<int>(std::lround(begin.y)) + y;
      const double expected = stored_depth(cascade, (glm::dvec2(column, row) + 0.5) * texel, plane);
      if (expected <= 0.0 || expected >= 1.0) continue;
      const float stored = atlas.depth[texel_index(row, atlas.width, column)];
      if (stored == farthest_depth(frame)) {
        error.missing += std::abs(expected - double(stored)) > allowed ? 1U : 0U;
        continue;
      }
      ++error.texels;
      error.worst = std::max(error.worst, std::abs(stored - expected));
      error.worst_allowed = std::max(error.worst_allowed, std::abs(stored - expected) / allowed);
    }
  }
  return error;
}

struct MapCase {
  bool reversed_z;
  DepthFormat format;
};

void PrintTo(const MapCase& one, std::ostream* stream) {
  *stream << (one.reversed_z ? "reversed" : "conventional") << " format " << static_cast<int>(one.format);
}

std::string case_name(const testing::TestParamInfo<MapCase>& info) {
  constexpr std::array names{"D16", "D24", "D32"};
  return std::string(info.param.reversed_z ? "Reversed" : "Conventional") +
         names.at(static_cast<std::size_t>(info.param.format));
}

class FrameMap : public RasterisedFrame, public testing::WithParamInterface<MapCase> {
 protected:
  FrameSettings settings(int cascades = 4) const {
    return unbiased_settings(GetParam().reversed_z, GetParam().format, cascades);
  }
  static std::size_t tile_texels(const Frame& frame) {
    return static_cast<std::size_t>(frame.cascades.tile_resolution) *
           static_cast<std::size_t>(frame.cascades.tile_resolution);
  }
};

INSTANTIATE_TEST_SUITE_P(All, FrameMap,
                         testing::Values(MapCase{false, DepthFormat::d16}, MapCase{false, DepthFormat::d24},
                                         MapCase{false, DepthFormat::d32}, MapCase{true, DepthFormat::d16},
                                         MapCase{true, DepthFormat::d24}, MapCase{true, DepthFormat::d32}),
                         case_name);

// The sloped ground also fixes the map's orientation: mirrored or turned, its gradient would not fit.
TEST_P(FrameMap, HoldsTheGroundsDepthInEveryCascade) {
  const Scene scene = ground_scene();
  const Frame frame = rasterise(*device, scene, settings());
  ASSERT_EQ(frame.cascades.cascades.size(), 4U);
  for (const parameters::Cascade& cascade : frame.cascades.cascades) {
    const MapError error = compare(frame, cascade, {{0, 1, 0}, 0.0});
    EXPECT_GT(error.texels, tile_texels(frame) / 2) << "cascade " << cascade.index;
    EXPECT_EQ(error.missing, 0U) << "cascade " << cascade.index;
    EXPECT_LE(error.worst_allowed, 1.0) << "cascade " << cascade.index << ", error " << error.worst;
  }
}

// Planes perpendicular to the light have no gradient, so only the format's own precision is left. All three
// stand before the far side of every cascade's sphere.
TEST_P(FrameMap, HoldsPerpendicularPlanesToTheFormatsPrecision) {
  for (const double distance : {-40.0, -20.0, -3.0}) {
    Scene scene = ground_scene();
    const glm::dvec3 along = scene.light_direction;
    scene.mesh = {};
    add_perpendicular_sheet(scene, distance);
    FrameSettings fixed = settings();
    fixed.shadows.depth_range_metres = 128.0;
    const Frame frame = rasterise(*device, scene, fixed);
    for (const parameters::Cascade& cascade : frame.cascades.cascades) {
      const MapError error = compare(frame, cascade, {along, distance});
      EXPECT_EQ(error.texels, tile_texels(frame)) << "the sheet covers the tile";
      EXPECT_LE(error.worst_allowed, 1.0) << "cascade " << cascade.index << ", error " << error.worst;
    }
  }
}

TEST_P(FrameMap, LeavesTheQuarterWithoutATileClear) {
  const Frame frame = rasterise(*device, ground_scene(), settings(3));
  const int side = frame.cascades.tile_resolution;
  ASSERT_EQ(frame.atlas.width, 2 * side);
  ASSERT_EQ(frame.atlas.height, 2 * side);
  std::size_t drawn = 0;
  for (int y = side; y < 2 * side; ++y) {
    for (int x = side; x < 2 * side; ++x) {
      drawn += frame.atlas.depth[texel_index(y, frame.atlas.width, x)] != farthest_depth(frame);
    }
  }
  EXPECT_EQ(drawn, 0U);
}

TEST_P(FrameMap, DrawsWhatIsNearerThanTheNearPlaneOntoIt) {
  Scene scene = ground_scene();
  add_perpendicular_sheet(scene, -60.0);  // this sheet is far toward the light, over everything
  FrameSettings tight = settings(1);
  tight.shadows.depth_range_metres = 5.0;
  const Frame frame = rasterise(*device, scene, tight);
  for (const float depth : frame.atlas.depth) ASSERT_EQ(depth, nearest_depth(frame));
}

// Biased casters move by b.x against the way to the light and by (1 - cosine) b.y along their normal, so the
// ground, at cosine c, sinks by c |b.x| + (1 - c) |b.y|.
TEST_P(FrameMap, SinksTheGroundByUrpsBias) {
  Scene scene = ground_scene();
  FrameSettings biased = settings(2);
  biased.shadows.depth_bias = 1.0;
  biased.shadows.normal_bias = 3.0;  // at 2 a flipped light happens to sink it alike
  const Frame frame = rasterise(*device, scene, biased);
  ASSERT_EQ(frame.atlas.height, frame.atlas.width / 2);
  const double cosine = -scene.light_direction.y;
  for (const parameters::Cascade& cascade : frame.cascades.cascades) {
    const double height = cosine * cascade.depth_bias_metres + (1.0 - cosine) * cascade.normal_bias_metres;
    EXPECT_LT(height, -0.02) << "too little to test";
    const MapError error = compare(frame, cascade, {{0, 1, 0}, height});
    EXPECT_GT(error.texels, tile_texels(frame) / 2);
    EXPECT_LE(error.worst_allowed, 1.0) << "cascade " << cascade.index << ", error " << error.worst;
  }
}

TEST_P(FrameMap, KeepsItsTexelsBitsBesideTheirValues) {
  const Frame frame = rasterise(*device, ground_scene(), settings());
  const std::size_t count = frame.atlas.depth.size();
  const std::size_t bytes = GetParam().format == DepthFormat::d16 ? 2 : 4;
  ASSERT_EQ(frame.atlas.texels.size(), count * bytes);
  for (std::size_t texel = 0; texel < count; ++texel) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &frame.atlas.texels[texel * bytes], bytes);
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof(value));
    const double largest = GetParam().format == DepthFormat::d16 ? 65535.0 : 16777215.0;
    if (GetParam().format != DepthFormat::d32) value = static_cast<float>(bits / largest);
    ASSERT_EQ(frame.atlas.depth[texel], value);
  }
}

// The map is drawn from positions relative to the origin: 100 km away it errs no more than here.
TEST_P(FrameMap, IsAsExactFarFromTheOrigin) {
  Scene scene = ground_scene();
  scene.origin = {1e5, 0.0, -1e5};
  const Frame frame = rasterise(*device, scene, settings());
  for (const parameters::Cascade& cascade : frame.cascades.cascades) {
    const MapError error = compare(frame, cascade, {{0, 1, 0}, 0.0});
    EXPECT_GT(error.texels, tile_texels(frame) / 2);
    EXPECT_LE(error.worst_allowed, 1.0) << "cascade " << cascade.index << ", error " << error.worst;
  }
}

// The tower is far taller than the shadow distance, and the sun stands just above the horizon.
TEST_F(RasterisedFrame, ClampsNoCasterWhenTheSceneFixesTheNearPlane) {
  for (const double sun_degrees : {60.0, 2.0}) {
    Scene scene = ground_scene();
    scene.light_direction = sunlight(sun_degrees, 30.0);
    add_sheet(scene.mesh, {0, 60, 15}, {1, 0, 0}, {0, 60, 0}, {0, 0, -1});
    const Frame frame = rasterise(*device, scene, unbiased_settings(true, DepthFormat::d32));
    std::size_t drawn = 0;
    for (const float depth : frame.atlas.depth) {
      ASSERT_LT(depth, 1.0F);
      drawn += depth > 0.0F ? 1U : 0U;
    }
    EXPECT_GT(drawn, frame.atlas.depth.size() / 10) << sun_degrees;
  }
}

TEST_F(RasterisedFrame, RepeatsToTheByteFromOneRasteriser) {
  const Scene scene = built_in("contact-boxes");
  Rasteriser rasteriser(*device, scene);
  const FrameSettings d16 = unbiased_settings(true, DepthFormat::d16);
  const FrameSettings d32 = unbiased_settings(false, DepthFormat::d32);
  const Frame first = rasteriser.frame(d16);
  rasteriser.frame(d32);
  const Frame again = rasteriser.frame(d16);
  EXPECT_EQ(first.atlas.texels, again.atlas.texels);
  EXPECT_EQ(first.receivers.position_ws, again.receivers.position_ws);
  EXPECT_EQ(first.atlas.texels, rasterise(*device, scene, d16).atlas.texels);
}

// Filters meet this when the sun moves on: the map and the matrices of before, the receivers of now.
TEST_F(RasterisedFrame, HasAnOldMapInTheLightOfBefore) {
  const Scene now = built_in("contact-boxes");
  Scene before = now;
  before.light_direction = sun_before(now.light_direction, 0.5);
  FrameSettings old = unbiased_settings(true, DepthFormat::d32);
  const Frame of_before = rasterise(*device, before, old);
  old.cascade_choices.map_age_degrees = 0.5;
  const Frame frame = rasterise(*device, now, old);
  EXPECT_EQ(frame.atlas.texels, of_before.atlas.texels);
  EXPECT_NE(frame.atlas.texels,
            rasterise(*device, now, unbiased_settings(true, DepthFormat::d32)).atlas.texels);
  for (std::size_t i = 0; i < frame.cascades.cascades.size(); ++i)
    EXPECT_EQ(frame.cascades.cascades[i].world_to_shadow, of_before.cascades.cascades[i].world_to_shadow);
  EXPECT_EQ(frame.receivers.position_ws, of_before.receivers.position_ws);
}

TEST_F(RasterisedFrame, RefusesScenesAndSettingsItCannotDraw) {
  const FrameSettings good = unbiased_settings(true, DepthFormat::d32);
  Scene empty = ground_scene();
  empty.mesh = {};
  EXPECT_THROW(rasterise(*device, empty, good), InputError);
  Scene astray = ground_scene();
  astray.mesh.indices[4] = 99;
  EXPECT_THROW(rasterise(*device, astray, good), InputError);
  Scene bare = ground_scene();
  bare.mesh.normals.pop_back();
  EXPECT_THROW(rasterise(*device, bare, good), InputError);
  FrameSettings flat = good;
  flat.height = 0;
  EXPECT_THROW(rasterise(*device, ground_scene(), flat), InputError);
  FrameSettings none = good;
  none.shadows.cascades = 0;
  EXPECT_THROW(rasterise(*device, ground_scene(), none), InputError);
}

}  // namespace
}  // namespace penumbra::scene
