// Tests the plane and the balls that stand for a scene's mesh.
#include "scene/stand_ins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/mesh_builder.h"

namespace penumbra::scene {
namespace {

Scene built(MeshBuilder& mesh) {
  Scene scene;
  mesh.move_into(scene);
  return scene;
}

TEST(GroundLevel, IsThatOfTheMostLevelAreaThatFacesUp) {
  MeshBuilder mesh;
  mesh.ground({0.0, 0.0, 0.0}, 20.0);
  mesh.standing_box({0.0, -3.0, 0.0}, {30.0, 0.5, 30.0}, 10.0);  // this is a cellar, whose floor is smaller
  mesh.standing_box({1.0, 0.0, 2.0}, {1.0, 2.0, 3.0}, 30.0);
  EXPECT_NEAR(ground_level(built(mesh).mesh), 0.0, 1e-6);
  MeshBuilder slab;
  slab.standing_box({0.0, -1.0, 0.0}, {30.0, 0.75, 30.0}, 0.0);
  EXPECT_NEAR(ground_level(built(slab).mesh), -0.25, 1e-6) << "not its underside, which is as large";
}

TEST(GroundLevel, OfAMeshWithoutLevelFacesIsItsLowestVertex) {
  Mesh mesh;
  mesh.positions = {{0.0F, 2.0F, 0.0F}, {1.0F, 1.5F, 0.0F}, {0.0F, 3.0F, 1.0F}};
  mesh.indices = {0, 1, 2};
  EXPECT_EQ(ground_level(mesh), 1.5);
  EXPECT_EQ(ground_level(Mesh{}), 0.0);
}

TEST(ObjectBalls, HaveAQuarterOfTheSurfaceAndItsCentre) {
  MeshBuilder mesh;
  mesh.ground({0.0, 0.0, 0.0}, 20.0);
  mesh.standing_box({3.0, 0.0, 4.0}, {1.0, 1.0, 1.0}, 30.0);
  mesh.standing_box({-3.0, 1.0, -4.0}, {2.0, 1.0, 0.5}, 0.0);
  const std::vector<Ball> balls = object_balls(built(mesh).mesh, 16);
  ASSERT_EQ(balls.size(), 2U);
  // The larger ball comes first. The underside of the first box lies in the ground, and belongs to it.
  EXPECT_NEAR(balls[0].radius, std::sqrt((4.0 + 2.0 + 1.0) / (4.0 * std::numbers::pi)), 1e-6);
  EXPECT_NEAR(glm::length(balls[0].centre - glm::dvec3(-3.0, 1.5, -4.0)), 0.0, 1e-6);
  EXPECT_NEAR(balls[1].radius, std::sqrt(5.0 / (4.0 * std::numbers::pi)), 1e-6);
  EXPECT_NEAR(glm::length(balls[1].centre - glm::dvec3(3.0, (4.0 * 0.5 + 1.0) / 5.0, 4.0)), 0.0, 1e-6);
}

TEST(ObjectBalls, AreTheLargestOfThoseThatAreNotAsLongAsTheScene) {
  MeshBuilder mesh;
  mesh.ground({0.0, 0.0, 0.0}, 20.0);
  mesh.standing_box({0.0, 0.0, 15.0}, {30.0, 4.0, 0.5}, 0.0);  // a wall
  for (int i = 0; i < 40; ++i)
    mesh.standing_box({-18.0 + 0.9 * i, 0.0, 0.0}, {0.2 + 0.01 * i, 0.3, 0.2}, 5.0 * i);
  const std::vector<Ball> balls = object_balls(built(mesh).mesh, 16);
  ASSERT_EQ(balls.size(), 16U);
  for (std::size_t i = 0; i < balls.size(); ++i)
    EXPECT_NEAR(balls[i].centre.x, -18.0 + 0.9 * (39.0 - static_cast<double>(i)), 1e-4);
}

}  // namespace
}  // namespace penumbra::scene
