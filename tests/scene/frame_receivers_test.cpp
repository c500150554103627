// Compares what the camera sees with rays through pixel centres, near the world's origin and 100 km from it.
#include <cmath>
#include <glm/trigonometric.hpp>
#include <iostream>

#include "scene/frame_scene.h"

namespace penumbra::scene {
namespace {

Scene ground_and_wall() {
  Scene scene = ground_scene();
  scene.camera.forward = {0.1, -0.1, 1.0};
  add_sheet(scene.mesh, {2, 2, 10}, {3, 0, 0.5}, {0, 2, 0}, {0, 0, -1});
  return scene;
}

// The direction through the centre of a pixel, row 0 at the top, in Unity's left-handed space.
glm::dvec3 ray(const parameters::Camera& camera, int column, int row, const Receivers& picture) {
  const glm::dvec3 forward = glm::normalize(camera.forward);
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, forward));
  const glm::dvec3 up = glm::cross(forward, right);
  const double tan_half = std::tan(glm::radians(camera.fov_y_degrees) / 2.0);
  const double x = ((column + 0.5) / picture.width * 2.0 - 1.0) * tan_half * camera.aspect;
  const double y = (1.0 - (row + 0.5) / picture.height * 2.0) * tan_half;
  return glm::normalize(forward + right * x + up * y);
}

struct Seen {
  double distance = HUGE_VAL;
  glm::dvec3 normal{0.0};
  double edge = HUGE_VAL;  // distance of the ray from the sheet's border, in units of its half-extent
};

// The two sheets of ground_and_wall are traced by hand, the wall first.
Seen trace(const glm::dvec3& from, const glm::dvec3& direction) {
  Seen seen;
  const glm::dvec3 u(3, 0, 0.5);
  const glm::dvec3 normal = glm::normalize(glm::cross(u, glm::dvec3(0, 1, 0)));
  const double wall = glm::dot(normal, glm::dvec3(2, 2, 10) - from) / glm::dot(normal, direction);
  const glm::dvec3 on_wall = from + direction * wall - glm::dvec3(2, 2, 10);
  const double inside = std::max(std::abs(glm::dot(on_wall, u) / glm::dot(u, u)), std::abs(on_wall.y) / 2.0);
  seen.edge = std::abs(inside - 1.0);
  const double ground = -from.y / direction.y;
  if (ground > 0.0) seen = {ground, {0, 1, 0}, seen.edge};
  if (wall > 0.0 && inside < 1.0 && wall < seen.distance) {
    seen = {wall, glm::dot(normal, direction) < 0.0 ? normal : -normal, seen.edge};
  }
  return seen;
}

TEST_F(RasterisedFrame, ReceiversAreWhereTheRaysThroughPixelCentresHit) {
  const Scene scene = ground_and_wall();
  FrameSettings settings = unbiased_settings(true, DepthFormat::d32);
  settings.shadows.distance_metres = 22.0;
  const Frame frame = rasterise(*device, scene, settings);
  const Receivers& seen = frame.receivers;
  ASSERT_EQ(seen.position_ws.size(), 96U * 54U);
  int walls = 0;
  int empty = 0;
  for (int row = 0; row < seen.height; ++row) {
    for (int column = 0; column < seen.width; ++column) {
      const auto pixel = texel_index(row, seen.width, column);
      const glm::dvec3 direction = ray(scene.camera, column, row, seen);
      const Seen expected = trace(scene.camera.position, direction);
      if (expected.edge < 0.02 || std::abs(expected.distance - 22.0) < 0.1) continue;  // either may win
      const bool hit = expected.distance < 22.0;
      ASSERT_EQ(seen.position_ws[pixel].w, hit ? 1.0F : 0.0F) << column << ", " << row;
      if (!hit) ++empty;
      if (!hit) continue;
      const glm::dvec3 position(seen.position_ws[pixel]);
      const glm::dvec3 miss = position - (scene.camera.position + direction * expected.distance);
      // Vertices snap to 1/256 pixel and floats interpolate: a hundredth of a pixel on the surface, of which
      // nothing may lie along the normal but the rounding of the position.
      const double pixel_metres = expected.distance * 2.0 * std::tan(glm::radians(30.0)) / seen.height;
      EXPECT_LT(glm::length(miss), 0.01 * pixel_metres / std::abs(glm::dot(direction, expected.normal)));
      EXPECT_LE(std::abs(glm::dot(miss, expected.normal)), std::ldexp(glm::length(position), -23));
      EXPECT_LT(glm::length(glm::dvec3(seen.normal_ws[pixel]) - expected.normal), 1e-6);
      walls += expected.normal.y == 0.0;
    }
  }
  EXPECT_GT(walls, 300);
  EXPECT_GT(empty, 300);
}

// Whether the ray through the pixel's centre meets the triangle, up to a hundredth of its size.
bool meets(const Mesh& mesh, std::uint32_t triangle, const glm::dvec3& from, const glm::dvec3& direction) {
  const auto corner = [&](std::uint32_t k) {
    return glm::dvec3(mesh.positions[mesh.indices[3 * triangle + k]]);
  };
  const glm::dvec3 ab = corner(1) - corner(0);
  const glm::dvec3 ac = corner(2) - corner(0);
  const glm::dvec3 across = glm::cross(direction, ac);
  const glm::dvec3 to_eye = from - corner(0);
  const double determinant = glm::dot(ab, across);
  const double b = glm::dot(to_eye, across) / determinant;
  const double c = glm::dot(direction, glm::cross(to_eye, ab)) / determinant;
  return std::min({b, c, 1.0 - b - c}) > -0.01;
}

TEST_F(RasterisedFrame, EveryPixelNamesItsTriangleAtAnyDistance) {
  const Scene scene = ground_and_wall();
  FrameSettings settings = unbiased_settings(true, DepthFormat::d32);
  settings.shadows.distance_metres = 5.0;
  const Receivers seen = rasterise(*device, scene, settings).receivers;
  int beyond = 0;
  int sky = 0;
  for (int row = 0; row < seen.height; ++row) {
    for (int column = 0; column < seen.width; ++column) {
      const auto pixel = texel_index(row, seen.width, column);
      if (seen.triangle[pixel] == no_triangle) {
        ASSERT_EQ(seen.position_ws[pixel].w, 0.0F);
        ++sky;
        continue;
      }
      ASSERT_TRUE(meets(scene.mesh, seen.triangle[pixel], scene.camera.position,
                        ray(scene.camera, column, row, seen)))
          << column << ", " << row;
      beyond += seen.position_ws[pixel].w == 0.0F;
    }
  }
  EXPECT_GT(beyond, 300);
  EXPECT_GT(sky, 300);
}

TEST_F(RasterisedFrame, NormalsFaceTheCameraFromBothSides) {
  Scene scene = ground_scene();
  scene.camera.position.y = -3.0;  // the camera is below the ground and looks up
  scene.camera.forward = {0.0, 0.3, 1.0};
  const Frame frame = rasterise(*device, scene, unbiased_settings(true, DepthFormat::d32));
  int seen = 0;
  for (std::size_t pixel = 0; pixel < frame.receivers.position_ws.size(); ++pixel) {
    if (frame.receivers.position_ws[pixel].w == 0.0F) continue;
    ++seen;
    ASSERT_EQ(frame.receivers.normal_ws[pixel], glm::vec4(0, -1, 0, 0));
  }
  EXPECT_GT(seen, 1000);
}

// The error a shader makes there is that of its float position and matrix. Each of the four products and of
// their three sums rounds once, as do matrix and position: at most 6 half-ULPs of the terms' sum.
TEST_F(RasterisedFrame, ASceneMoved100KilometresErrsByTheFloatsOfItsWorldPositionsOnly) {
  Scene scene = ground_and_wall();
  const FrameSettings settings = unbiased_settings(true, DepthFormat::d32);
  const Frame here = rasterise(*device, scene, settings);
  scene.origin = {1e5, 0.0, -1e5};
  const Frame there = rasterise(*device, scene, settings);

  EXPECT_EQ(here.receivers.position_relative, there.receivers.position_relative);
  EXPECT_EQ(here.receivers.normal_ws, there.receivers.normal_ws);
  const parameters::Cascade& cascade = there.cascades.cascades[0];
  const glm::mat4 matrix(cascade.world_to_shadow);
  double position_error = 0.0;
  glm::dvec3 coordinate_error(0.0);
  for (std::size_t pixel = 0; pixel < there.receivers.position_ws.size(); ++pixel) {
    if (there.receivers.position_ws[pixel].w == 0.0F) continue;
    const glm::dvec3 exact = scene.origin + glm::dvec3(there.receivers.position_relative[pixel]);
    const glm::vec3 world(there.receivers.position_ws[pixel]);
    // 1e5 lies between 2^16 and 2^17: half an ULP is 2^-8 m per axis; the relative position rounds as well.
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_LE(std::abs(world[axis] - exact[axis]), std::ldexp(1.0, -8) + 1e-5);
    }
    position_error = std::max(position_error, glm::length(glm::dvec3(world) - exact));
    const glm::dvec3 wanted(cascade.world_to_shadow * glm::dvec4(exact, 1.0));
    const glm::vec3 got(matrix * glm::vec4(world, 1.0F));
    for (int row = 0; row < 3; ++row) {
      double terms = std::abs(matrix[3][row]);
      for (int axis = 0; axis < 3; ++axis) terms += std::abs(double(matrix[axis][row]) * exact[axis]);
      const double error = std::abs(double(got[row]) - wanted[row]);
      ASSERT_LE(error, 6.0 * std::ldexp(terms, -24)) << "row " << row;
      coordinate_error[row] = std::max(coordinate_error[row], error);
    }
  }
  const double texels =
      std::max(coordinate_error.x * there.atlas.width, coordinate_error.y * there.atlas.height);
  std::cout << "moved 1e5 m: world position off by up to " << position_error << " m, map coordinate by "
            << texels << " texels of " << cascade.texel_size_metres << " m, depth by "
            << coordinate_error.z / cascade.depth_per_metre << " m\n";
  RecordProperty("position_error_metres", std::to_string(position_error));
  RecordProperty("coordinate_error_texels", std::to_string(texels));
  RecordProperty("depth_error_metres", std::to_string(coordinate_error.z / cascade.depth_per_metre));
  EXPECT_GT(position_error, 1e-3) << "the test moved nothing";
}

}  // namespace
}  // namespace penumbra::scene
