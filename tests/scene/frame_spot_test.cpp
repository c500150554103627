// Compares a spot light's map with rays from its position.
#include <cmath>
#include <glm/trigonometric.hpp>

#include "input/input_error.h"
#include "scene/frame_scene.h"

namespace penumbra::scene {
namespace {

parameters::SpotLight lamp() {
  parameters::SpotLight light;
  light.position = {0.4, 3.0, 4.0};
  light.direction = {0.2, -1.0, 0.5};
  light.outer_angle_degrees = 50.0;
  light.shadow_guard_degrees = 10.0;
  light.range_metres = 9.0;
  return light;
}

Scene lamp_scene() {
  Scene scene = ground_scene();
  scene.spot_light = lamp();
  // The ground does not go far beyond the light's reach, because float coordinates of 100 m would tell.
  scene.mesh = {};
  add_sheet(scene.mesh, {0, 0, 8}, {20, 0, 0}, {0, 0, 20}, {0, 1, 0});
  return scene;
}

// The rays lead from the light through a texel's centre and are an axial metre long; they are computed anew
// from the light's own numbers.
class MapRays {
 public:
  MapRays(const parameters::SpotLight& light, int resolution) : light_(light), resolution_(resolution) {
    forward_ = glm::normalize(light.direction);
    right_ = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), forward_));
    up_ = glm::cross(forward_, right_);
    half_width_ = std::tan(0.5 * glm::radians(light.outer_angle_degrees + light.shadow_guard_degrees));
  }

  glm::dvec3 direction(double column, double row) const {
    const double across = 2.0 * (column + 0.5) / resolution_ - 1.0,
                 along = 2.0 * (row + 0.5) / resolution_ - 1.0;
    return forward_ + half_width_ * (across * right_ + along * up_);
  }
  // The axial metres to a plane normal . p = offset.
  double to_plane(double column, double row, const glm::dvec3& normal, double offset) const {
    return (offset - glm::dot(normal, light_.position)) / glm::dot(normal, direction(column, row));
  }
  double stored(double axial, bool reversed_z) const {
    const double near = light_.shadow_near_plane_metres, far = light_.range_metres;
    const double from_near = far / (far - near) * (1.0 - near / axial);
    return reversed_z ? 1.0 - from_near : from_near;
  }

 private:
  parameters::SpotLight light_;
  int resolution_;
  glm::dvec3 forward_, right_, up_;
  double half_width_ = 0.0;
};

struct MapError {
  int texels = 0;
  int beyond = 0;              // texels beyond the range, or in front of the near plane
  int clear = 0;               // clear ones of these
  double worst_allowed = 0.0;  // largest error as a share of what is allowed
};

// The allowed error is half a step of the format, vertices snapped to 1/256 texel, and float rounding as in
// the sun's maps.
MapError compare(const Frame& frame, const MapRays& rays, const glm::dvec3& normal, double offset) {
  const bool reversed_z = frame.cascades.reversed_z;
  const auto stored = [&](double column, double row) {
    return rays.stored(rays.to_plane(column, row, normal, offset), reversed_z);
  };
  MapError error;
  for (int row = 0; row < frame.atlas.height; ++row) {
    for (int column = 0; column < frame.atlas.width; ++column) {
      const double axial = rays.to_plane(column, row, normal, offset);
      const float texel = frame.atlas.depth[texel_index(row, frame.atlas.width, column)];
      if (axial > 8.9 && axial < 9.1) continue;
      if (!(axial > 0.21 && axial < 9.0)) {
        ++error.beyond;
        error.clear += texel == farthest_depth(frame) ? 1 : 0;
        continue;
      }
      const double expected = stored(column, row);
      const double gradient =
          std::abs(stored(column + 1, row) - expected) + std::abs(stored(column, row + 1) - expected);
      const double allowed =
          0.5 * format_step(frame.settings.format) + gradient / 256.0 + 16.0 * std::ldexp(1.0, -24);
      ++error.texels;
      error.worst_allowed = std::max(error.worst_allowed, std::abs(texel - expected) / allowed);
    }
  }
  return error;
}

TEST_F(RasterisedFrame, OfASpotLightHoldsTheGroundsDepth) {
  for (const bool reversed_z : {false, true}) {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32}) {
      for (const glm::dvec3& origin : {glm::dvec3(0.0), glm::dvec3(1e5, 0.0, -1e5)}) {
        Scene scene = lamp_scene();
        scene.origin = origin;
        const Frame frame = rasterise(*device, scene, unbiased_settings(reversed_z, format, 1));
        ASSERT_TRUE(frame.spot_shadow);
        EXPECT_TRUE(frame.cascades.cascades.empty());
        EXPECT_EQ(frame.spot_shadow->light.position, scene.spot_light->position + origin);
        ASSERT_EQ(frame.atlas.width, 512);
        ASSERT_EQ(frame.atlas.height, 512);
        const MapError error = compare(frame, {lamp(), 512}, {0, 1, 0}, 0.0);
        EXPECT_GT(error.texels, 512 * 512 * 3 / 4);
        EXPECT_LE(error.worst_allowed, 1.0) << reversed_z << " format " << static_cast<int>(format);
      }
    }
  }
}

// Beside the cone's map and beyond the range the light sees nothing.
TEST_F(RasterisedFrame, OfASpotLightIsClearBeyondItsRange) {
  Scene scene = lamp_scene();
  scene.spot_light->direction = {0.0, -0.1, 1.0};  // towards the horizon
  const MapRays rays(*scene.spot_light, 512);
  const Frame frame = rasterise(*device, scene, unbiased_settings(true, DepthFormat::d32, 1));
  const MapError error = compare(frame, rays, {0, 1, 0}, 0.0);
  EXPECT_GT(error.texels, 10000);
  EXPECT_GT(error.beyond, 10000);
  EXPECT_EQ(error.clear, error.beyond);
  EXPECT_LE(error.worst_allowed, 1.0);
}

TEST_F(RasterisedFrame, OfASpotLightLosesWhatIsNearerThanItsNearPlane) {
  const auto map_with_sheet_at = [&](double axial) {
    Scene scene = lamp_scene();
    const glm::dvec3 along = glm::normalize(scene.spot_light->direction);
    add_sheet(scene.mesh, scene.spot_light->position + axial * along, {0.02, 0, 0},
              glm::cross(along, glm::dvec3(0.02, 0, 0)), -along);
    return rasterise(*device, scene, unbiased_settings(true, DepthFormat::d32, 1)).atlas.depth;
  };
  const std::vector<float> bare =
      rasterise(*device, lamp_scene(), unbiased_settings(true, DepthFormat::d32, 1)).atlas.depth;
  EXPECT_EQ(map_with_sheet_at(0.15), bare);
  EXPECT_NE(map_with_sheet_at(0.25), bare);
}

// Each vertex moves along its own way to the light.
TEST_F(RasterisedFrame, OfASpotLightSinksATriangleByUrpsBias) {
  Scene scene = lamp_scene();
  scene.mesh = {};
  scene.mesh.positions = {{-9, 0.3F, -3}, {0, 0, 19}, {11, -0.2F, -2}};
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.1, 1.0, -0.2));
  scene.mesh.normals.assign(3, glm::vec3(normal));
  scene.mesh.indices = {0, 1, 2};
  FrameSettings biased = unbiased_settings(true, DepthFormat::d32, 1);
  biased.shadows.depth_bias = 1.0;
  biased.shadows.normal_bias = 3.0;
  const double texel = std::tan(glm::radians(25.0)) * 9.0 / 512.0 * 2.5;
  glm::dvec3 corner[3];
  for (int k = 0; k < 3; ++k) {
    const glm::dvec3 position(scene.mesh.positions[k]);
    const glm::dvec3 toward = glm::normalize(lamp().position - position);
    const double cosine = glm::clamp(glm::dot(toward, normal), 0.0, 1.0);
    corner[k] = position - toward * texel - normal * ((1.0 - cosine) * 3.0 * texel);
  }
  const glm::dvec3 plane = glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
  const Frame frame = rasterise(*device, scene, biased);
  const MapError error = compare(frame, {lamp(), 512}, plane, glm::dot(plane, corner[0]));
  EXPECT_GT(error.texels, 512 * 512 / 2);
  EXPECT_LE(error.worst_allowed, 1.0);
  EXPECT_GT(compare(rasterise(*device, scene, unbiased_settings(true, DepthFormat::d32, 1)), {lamp(), 512},
                    plane, glm::dot(plane, corner[0]))
                .worst_allowed,
            2.0)
      << "too little to test";
}

TEST_F(RasterisedFrame, OfASpotLightRefusesWhatCannotBe) {
  Scene scene = lamp_scene();
  scene.spot_light->outer_angle_degrees = 200.0;
  EXPECT_THROW(rasterise(*device, scene, unbiased_settings(true, DepthFormat::d32, 1)), InputError);
}

}  // namespace
}  // namespace penumbra::scene
