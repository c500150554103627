#include "lighting/seen_materials.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "input/input_error.h"
#include "lighting/hand_made.h"

namespace penumbra::lighting {
namespace {

scene::Texture two_columns(std::uint8_t left, std::uint8_t right) {
  return {2, 1, {left, left, left, 255, right, right, right, 255}};
}

scene::Scene floor_of_side(double half) {
  scene::Scene scene = hand_made::looking_down(10.0, glm::normalize(glm::dvec3(1, 2, 0.5)));
  hand_made::add_square(scene, {0, 0, 0}, {half, 0, 0}, {0, 0, half});
  return scene;
}

TEST(SeenMaterials, PointsLieWhereThePixelsRaysMeetTheFloor) {
  const scene::Scene scene = floor_of_side(3.0);
  const scene::Frame frame = hand_made::frame_of(scene, 24, 24);
  const SeenMaterials seen = seen_materials(scene, frame);
  int floor = 0;
  for (int row = 0; row < 24; ++row) {
    for (int column = 0; column < 24; ++column) {
      const auto pixel = static_cast<std::size_t>(row * 24 + column);
      const glm::dvec3 direction = hand_made::pixel_direction(scene, frame.settings, column, row);
      EXPECT_LT(glm::distance(glm::dvec3(seen.view_direction[pixel]), direction), 1e-6);
      const glm::dvec3 hit = scene.camera.position - direction * (scene.camera.position.y / direction.y);
      const bool on_floor = std::abs(hit.x) < 3.0 && std::abs(hit.z) < 3.0;
      ASSERT_EQ(seen.seen[pixel] != 0, on_floor) << column << ", " << row;
      if (!on_floor) continue;
      EXPECT_LT(glm::distance(glm::dvec3(seen.points[pixel].position), hit), 1e-5);
      EXPECT_LT(glm::distance(seen.points[pixel].normal, glm::vec3(0, 1, 0)), 1e-6F);
      ++floor;
    }
  }
  EXPECT_GT(floor, 50);
}

TEST(SeenMaterials, NormalsAreInterpolatedAndFaceTheCamera) {
  scene::Scene scene = floor_of_side(3.0);
  scene.mesh.normals[0] = scene.mesh.normals[3] =
      glm::normalize(glm::vec3(-1, -1, 0));  // direction of the left edge, downwards
  scene.mesh.normals[1] = scene.mesh.normals[2] = glm::normalize(glm::vec3(1, -1, 0));
  const scene::Frame frame = hand_made::frame_of(scene, 24, 24);
  const SeenMaterials seen = seen_materials(scene, frame);
  const auto normal_at = [&](int column) {
    return seen.points[static_cast<std::size_t>(12 * 24 + column)].normal;
  };
  EXPECT_GT(normal_at(9).y, 0.6F);
  EXPECT_GT(normal_at(9).x, 0.05F) << "turned over, the left one leans to the right";
  EXPECT_LT(normal_at(14).x, -0.05F);
  EXPECT_NEAR(normal_at(9).x, -normal_at(14).x, 1e-5F);
  for (int column = 8; column < 16; ++column) {
    EXPECT_NEAR(glm::length(normal_at(column)), 1.0F, 1e-6F);
    EXPECT_EQ(seen.points[static_cast<std::size_t>(12 * 24 + column)].flat_normal, glm::vec3(0, 1, 0));
  }
}

TEST(SeenMaterials, AColourTextureMultipliesTheColour) {
  scene::Scene scene = floor_of_side(3.0);
  scene.textures = {two_columns(0, 255)};
  scene.materials[0].base_colour = {1.0F, 0.5F, 0.25F};
  scene.materials[0].base_colour_texture = 0;
  const SeenMaterials seen = seen_materials(scene, hand_made::frame_of(scene, 96, 96));
  const auto colour_at = [&](int column) {
    return seen.points[static_cast<std::size_t>(48 * 96 + column)].base_colour;
  };
  // No pixel's centre is a texel's: some thousandths of the other column mix in.
  EXPECT_LT(glm::distance(colour_at(60), glm::vec3(1.0F, 0.5F, 0.25F)), 5e-3F) << "u = 3/4 is right";
  EXPECT_LT(glm::length(colour_at(35)), 5e-3F);
  EXPECT_NEAR(mean_colours(scene)[0].r, 0.5F, 1e-6F);
}

// The map leans to +X of the texture (right in the picture) and to +Y (up: away along +Z here).
TEST(SeenMaterials, ANormalMapLeansAsGltfSays) {
  scene::Scene scene = floor_of_side(5.0);
  scene.materials[0].normal_texture = 0;
  const auto normal_of = [&](std::uint8_t x, std::uint8_t y) {
    scene.textures = {{1, 1, {x, y, 218, 255}}};
    return seen_materials(scene, hand_made::frame_of(scene, 8, 8)).points[27].normal;
  };
  EXPECT_GT(normal_of(218, 128).x, 0.6F);
  EXPECT_NEAR(normal_of(218, 128).z, 0.0F, 0.01F);
  EXPECT_GT(normal_of(128, 218).z, 0.6F);
  EXPECT_NEAR(normal_of(128, 218).x, 0.0F, 0.01F);
  EXPECT_GT(normal_of(128, 218).y, 0.6F);
}

TEST(SeenMaterials, EveryTriangleHasItsOwnMaterial) {
  scene::Scene scene = floor_of_side(5.0);
  scene.materials.push_back(
      {.name = "leaf", .base_colour = {0, 1, 0}, .roughness = 0.3F, .translucency = 0.5F});
  scene.mesh.triangle_materials = {0, 1};
  const SeenMaterials seen = seen_materials(scene, hand_made::frame_of(scene, 16, 16));
  int leaves = 0;
  for (const SurfacePoint& point : seen.points) {
    if (point.translucency == 0.0F) continue;
    EXPECT_EQ(point.base_colour, glm::vec3(0, 1, 0));
    EXPECT_EQ(point.roughness, 0.3F);
    ++leaves;
  }
  EXPECT_GT(leaves, 60);
  EXPECT_LT(leaves, 200);
}

TEST(SeenMaterials, WhatDoesNotFitIsRefused) {
  const scene::Scene good = floor_of_side(5.0);
  const scene::Frame frame = hand_made::frame_of(good, 4, 4);
  scene::Scene scene = good;
  scene.materials.clear();
  EXPECT_THROW(seen_materials(scene, frame), InputError);
  scene = good;
  scene.mesh.triangle_materials = {0, 1};
  EXPECT_THROW(seen_materials(scene, frame), InputError);
  scene = good;
  scene.mesh.uvs.pop_back();
  EXPECT_THROW(seen_materials(scene, frame), InputError);
  scene = good;
  scene.materials[0].normal_texture = 0;
  EXPECT_THROW(seen_materials(scene, frame), InputError);
  scene::Frame blind = frame;
  blind.receivers.triangle.clear();
  EXPECT_THROW(seen_materials(good, blind), InputError);
}

}  // namespace
}  // namespace penumbra::lighting
