// A small temple: columns over steps, an architrave and a roof edge, a wall behind that takes their shadows.
#include "scene/built_in_scenes.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

constexpr double kHalfWidth = 5.0;  // half of the platform's width, along x
constexpr double kLength = 32.0;    // along z
constexpr double kMiddle = 16.0;    // z of its centre
constexpr double kStep = 0.28;      // height of each of three steps
constexpr double kFloor = 3 * kStep;
constexpr double kColumn = 4.6;  // height of shaft, base and capital together

void add_column(MeshBuilder& mesh, const glm::dvec3& foot) {
  const auto up = [&](double y) { return foot + glm::dvec3(0, y, 0); };
  mesh.standing_box(foot, {1.0, 0.15, 1.0});
  mesh.tube({up(0.15), up(0.30), 0.46, 0.42, 24});
  mesh.tube({up(0.30), up(kColumn - 0.4), 0.38, 0.32, 24});
  mesh.tube({up(kColumn - 0.4), up(kColumn - 0.2), 0.33, 0.46, 24});
  mesh.standing_box(up(kColumn - 0.2), {1.0, 0.2, 1.0});
}

void add_roof(MeshBuilder& mesh) {
  const double top = kFloor + kColumn;
  for (const double x : {-4.3, 4.3}) mesh.standing_box({x, top, kMiddle}, {0.8, 0.6, kLength - 0.8});
  for (const double z : {0.8, kLength - 0.8}) {
    mesh.standing_box({0.0, top, z}, {7.8, 0.6, 0.8});
  }
  mesh.standing_box({0.0, top + 0.6, kMiddle}, {10.6, 0.25, kLength + 0.6});
  mesh.use(surfaces::roof_tile());
  mesh.gable({{0.0, top + 0.85, kMiddle}, {10.6, 2.0, kLength + 0.6}});
  mesh.use(surfaces::marble());
  // Dentils: a row of small blocks under the roof's edge.
  for (int i = 0; i < 64; ++i) {
    for (const double x : {-4.8, 4.8}) mesh.standing_box({x, top + 0.42, 0.25 + 0.5 * i}, {0.2, 0.18, 0.22});
  }
}

}  // namespace

Scene colonnade() {
  MeshBuilder mesh;
  mesh.use(surfaces::earth());
  mesh.ground({0.0, 0.0, 20.0}, 60.0);
  mesh.use(surfaces::marble());
  for (int i = 0; i < 3; ++i) {
    const double tread = 0.4 * (2 - i);
    mesh.standing_box({0.0, kStep * i, kMiddle}, {2 * (kHalfWidth + tread), kStep, kLength + 2 * tread});
  }
  for (int i = 0; i < 11; ++i) {
    for (const double x : {-4.3, 4.3}) add_column(mesh, {x, kFloor, 0.8 + 3.04 * i});
  }
  for (const double x : {-1.4, 1.4}) add_column(mesh, {x, kFloor, 0.8});
  mesh.use(surfaces::sandstone());
  mesh.standing_box({0.0, kFloor, kMiddle + 1.0}, {4.6, kColumn, kLength - 8.0});  // the cella's walls
  mesh.use(surfaces::marble());
  add_roof(mesh);
  // Fallen drums and a stela before the steps.
  mesh.tube({{-7.2, 0.38, 3.2}, {-6.4, 0.38, 3.9}, 0.38, 0.38, 24});
  mesh.tube({{-8.2, 0.0, 7.0}, {-8.2, 0.7, 7.0}, 0.38, 0.37, 24});
  mesh.standing_box({-7.4, 0.0, 10.5}, {0.25, 1.9, 0.7}, 20.0);
  Scene scene;
  mesh.move_into(scene);
  scene.camera = camera_looking({-2.9, kFloor + 1.7, 1.2}, {-3.7, 2.1, 10.0});
  scene.light_direction = sunlight(34.0, -62.0);
  return scene;
}

}  // namespace penumbra::scene
