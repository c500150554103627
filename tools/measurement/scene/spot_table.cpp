// A room under one lamp: penumbrae are a texel wide where things stand, and half a metre below the shelf and
// on the walls.
#include <cmath>
#include <numbers>

#include "scene/built_in_scenes.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

void add_room(MeshBuilder& mesh) {
  mesh.use(surfaces::wood());
  mesh.ground({0.0, 0.0, 2.0}, 4.0);
  mesh.use(surfaces::plaster(4));
  mesh.standing_box({0.0, 0.0, 5.1}, {6.4, 3.0, 0.2});
  mesh.standing_box({-3.1, 0.0, 2.0}, {0.2, 3.0, 6.0});
}

// A top of 1.4 m by 0.8 m at 0.74 m.
void add_table(MeshBuilder& mesh, const glm::dvec3& foot) {
  mesh.use(surfaces::painted_wood(3));
  mesh.standing_box(foot + glm::dvec3(0.0, 0.71, 0.0), {1.4, 0.03, 0.8});
  for (const double x : {-0.64, 0.64}) {
    for (const double z : {-0.34, 0.34}) mesh.standing_box(foot + glm::dvec3(x, 0.0, z), {0.05, 0.71, 0.05});
  }
}

void add_chair(MeshBuilder& mesh, const glm::dvec3& foot) {
  mesh.use(surfaces::painted_wood(5));
  mesh.standing_box(foot + glm::dvec3(0.0, 0.43, 0.0), {0.42, 0.03, 0.42});
  for (const double x : {-0.19, 0.19}) {
    mesh.standing_box(foot + glm::dvec3(x, 0.0, -0.19), {0.035, 0.43, 0.035});
    mesh.standing_box(foot + glm::dvec3(x, 0.0, 0.19), {0.035, 0.95, 0.035});
  }
  for (int i = 0; i < 4; ++i)
    mesh.standing_box(foot + glm::dvec3(0.0, 0.55 + 0.1 * i, 0.19), {0.35, 0.05, 0.02});
}

void add_ball(MeshBuilder& mesh, const glm::dvec3& centre, double radius) {
  Lathe ball;
  ball.pose.centre = centre;
  constexpr int kRings = 16;
  for (int i = 0; i <= kRings; ++i) {
    const double angle = std::numbers::pi * i / kRings;
    const bool pole = i == 0 || i == kRings;
    ball.profile.push_back({pole ? 0.0 : radius * std::sin(angle), -radius * std::cos(angle)});
  }
  mesh.lathe(ball);
}

// On the table, and beside it on the floor, are things that touch, that stand on thin legs, and that are
// thin.
void add_things(MeshBuilder& mesh, const glm::dvec3& top) {
  mesh.use(surfaces::painted_wood(2));
  mesh.standing_box(top + glm::dvec3(-0.5, 0.0, 0.05), {0.18, 0.11, 0.14}, 20.0);
  mesh.standing_box(top + glm::dvec3(-0.5, 0.11, 0.05), {0.10, 0.10, 0.10}, 55.0);
  mesh.use(surfaces::painted_wood(1));
  add_ball(mesh, top + glm::dvec3(0.42, 0.09, -0.1), 0.09);
  mesh.use(surfaces::galvanised_steel());
  for (int i = 0; i < 5; ++i) {
    const double radius = 0.003 + 0.002 * i;
    const glm::dvec3 foot = top + glm::dvec3(0.05 + 0.06 * i, 0.0, 0.24);
    mesh.tube({foot, foot + glm::dvec3(0.0, 0.3, 0.02), radius, radius, 8});
  }
  mesh.use(surfaces::terracotta());
  mesh.standing_box({1.5, 0.0, 3.4}, {0.4, 0.4, 0.4}, 30.0);
  mesh.standing_box({1.5, 0.4, 3.4}, {0.25, 0.25, 0.25}, 10.0);
  mesh.tube({{-1.5, 0.0, 3.6}, {-1.5, 1.6, 3.6}, 0.015, 0.015, 12});
  mesh.tube({{-1.75, 1.3, 3.6}, {-1.25, 1.3, 3.6}, 0.01, 0.01, 12});
}

// Slats at 1.5 m, half way to the lamp, and a shelf on the wall.
void add_high_things(MeshBuilder& mesh) {
  mesh.use(surfaces::wood());
  for (int i = 0; i < 8; ++i) mesh.standing_box({0.8 + 0.11 * i, 1.5, 2.2}, {0.06, 0.02, 0.9});
  mesh.standing_box({-0.9, 1.3, 4.85}, {1.6, 0.03, 0.3});
  mesh.use(surfaces::painted_wood(0));
  for (int i = 0; i < 6; ++i)
    mesh.standing_box({-1.5 + 0.12 * i, 1.33, 4.85}, {0.04, 0.2 + 0.02 * (i % 3), 0.16}, 4.0 * i);
}

}  // namespace

Scene spot_table() {
  MeshBuilder mesh;
  add_room(mesh);
  add_table(mesh, {0.0, 0.0, 2.4});
  add_chair(mesh, {-0.2, 0.0, 3.15});
  add_chair(mesh, {0.95, 0.0, 2.9});
  add_things(mesh, {0.0, 0.74, 2.4});
  add_high_things(mesh);
  Scene scene;
  mesh.move_into(scene);
  scene.camera = camera_looking({0.6, 1.65, 0.0}, {-0.05, 0.72, 2.8});
  scene.camera.fov_y_degrees = 48.0;
  scene.spot_light.emplace();
  scene.spot_light->position = {0.25, 2.6, 1.9};
  scene.spot_light->direction = {-0.06, -1.0, 0.4};
  scene.spot_light->outer_angle_degrees = 110.0;
  scene.spot_light->inner_angle_degrees = 70.0;
  scene.spot_light->range_metres = 8.0;
  scene.shadow_distance_metres = 20.0;
  return scene;
}

}  // namespace penumbra::scene
