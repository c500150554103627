// Makes scenes of single planes, whose maps and receivers have closed forms, and a device to draw them on.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>

#include "gpu/device.h"
#include "scene/frame.h"

namespace penumbra::scene {

class RasterisedFrame : public testing::Test {
 protected:
  void SetUp() override {
    device.emplace(gpu::DeviceOptions{.name = "", .validation = true, .timeout_seconds = 600.0});
    log = device->validation_log();
  }
  void TearDown() override {
    device.reset();
    ASSERT_TRUE(log) << "no device was opened";
    EXPECT_THAT(log->messages(), testing::IsEmpty());
  }

  std::optional<gpu::Device> device;
  std::shared_ptr<const gpu::ValidationLog> log;
};

inline double format_step(DepthFormat format) {
  if (format == DepthFormat::d16) return 1.0 / 65535.0;
  return format == DepthFormat::d24 ? 1.0 / 16777215.0 : 0x1p-24;
}

// Adds a parallelogram around centre with edges 2 u and 2 v; its vertex normals are normal.
inline void add_sheet(Mesh& mesh, const glm::dvec3& centre, const glm::dvec3& u, const glm::dvec3& v,
                      const glm::dvec3& normal) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::dvec3& corner : {centre - u - v, centre + u - v, centre + u + v, centre - u + v}) {
    mesh.positions.emplace_back(corner);
    mesh.normals.emplace_back(normal);
  }
  for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + corner);
}

inline Scene ground_scene() {
  Scene scene;
  scene.name = "ground";
  scene.camera.position = {0.0, 1.7, 0.0};
  scene.camera.forward = {0.1, -0.2, 1.0};
  scene.light_direction = glm::normalize(glm::dvec3(0.4, -0.8, 0.45));
  add_sheet(scene.mesh, {0, 0, 0}, {160, 0, 0}, {0, 0, 160}, {0, 1, 0});
  return scene;
}

// Adds a sheet across the light, distance metres along it from the origin, wider than any tile of these
// tests.
inline void add_perpendicular_sheet(Scene& scene, double distance) {
  const glm::dvec3 along = scene.light_direction;
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), along));
  add_sheet(scene.mesh, along * distance, right * 90.0, glm::cross(along, right) * 90.0, -along);
}

inline FrameSettings unbiased_settings(bool reversed_z, DepthFormat format, int cascades = 4) {
  FrameSettings settings;
  settings.shadows.cascades = cascades;
  settings.shadows.resolution = 512;
  settings.shadows.distance_metres = 30.0;
  settings.shadows.depth_bias = 0.0;
  settings.shadows.normal_bias = 0.0;
  settings.shadows.reversed_z = reversed_z;
  settings.format = format;
  settings.width = 96;
  settings.height = 54;
  return settings;
}

inline std::size_t texel_index(int row, int width, int column) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
}

inline float nearest_depth(const Frame& frame) {
  return frame.cascades.reversed_z ? 1.0F : 0.0F;
}
inline float farthest_depth(const Frame& frame) {
  return frame.cascades.reversed_z ? 0.0F : 1.0F;
}

}  // namespace penumbra::scene
