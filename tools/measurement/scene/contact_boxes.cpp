// Boxes that touch, lean and hover: penumbrae from nothing at a contact to a metre under a box in the air.
#include <cmath>

#include "scene/built_in_scenes.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

// The box is turned as given; its lowest corner is on the ground at y = 0.
void add_resting_box(MeshBuilder& mesh, double x, double z, const glm::dmat3& turned,
                     const glm::dvec3& size) {
  const double half_height = 0.5 * (std::abs(turned[0].y) * size.x + std::abs(turned[1].y) * size.y +
                                    std::abs(turned[2].y) * size.z);
  mesh.box({{x, half_height, z}, turned}, size);
}

void add_stack(MeshBuilder& mesh) {
  mesh.use(surfaces::painted_wood(0));
  mesh.standing_box({-2.2, 0.0, 3.0}, {1.6, 1.2, 1.6}, 12.0);
  mesh.use(surfaces::painted_wood(1));
  mesh.standing_box({-2.1, 1.2, 3.0}, {0.9, 0.8, 0.9}, 38.0);
  mesh.use(surfaces::painted_wood(2));
  mesh.standing_box({-2.2, 2.0, 3.1}, {0.4, 0.5, 0.4}, 65.0);
  mesh.use(surfaces::painted_wood(3));
  mesh.standing_box({-0.95, 0.0, 2.2}, {0.5, 0.5, 0.5}, 20.0);  // its corner reaches the stack's shadow
  mesh.use(surfaces::wood());
  // A plank leans towards the stack with its foot on the ground.
  add_resting_box(mesh, -3.55, 3.0, rotation(12.0, 0.0, -32.0), {0.06, 2.0, 0.5});
}

// The same cube at growing heights: one blocker shape, penumbra in proportion to the gap.
void add_hovering_row(MeshBuilder& mesh) {
  constexpr double gaps[] = {0.0, 0.02, 0.1, 0.4, 1.0, 2.5, 5.0};
  double x = -1.2;
  mesh.use(surfaces::painted_wood(5));
  for (const double gap : gaps) {
    mesh.standing_box({x, gap, 6.5}, {0.6, 0.6, 0.6}, 30.0);
    x += 1.5;
  }
}

void add_tilted_boxes(MeshBuilder& mesh) {
  for (int i = 0; i < 6; ++i) {
    mesh.use(surfaces::painted_wood(i));
    const double tilt = 10.0 + 12.0 * i;
    add_resting_box(mesh, 3.4 + 0.25 * i, 7.5 + 5.0 * i, rotation(15.0 * i, tilt, 0.5 * tilt),
                    {0.8, 0.8, 0.8});
  }
}

void add_far_towers(MeshBuilder& mesh) {
  mesh.use(surfaces::sandstone());
  mesh.standing_box({-6.0, 0.0, 14.0}, {2.0, 4.0, 2.0}, 25.0);
  mesh.standing_box({6.5, 0.0, 20.0}, {2.5, 6.0, 1.5}, -15.0);
  mesh.standing_box({-7.5, 0.0, 28.0}, {3.0, 3.0, 5.0}, 40.0);
  mesh.box({{0.0, 4.2, 24.0}, rotation(30.0, 20.0, 35.0)}, {2.0, 2.0, 2.0});
  mesh.standing_box({1.5, 0.0, 36.0}, {4.0, 5.0, 2.0}, 8.0);
}

void add_pebbles(MeshBuilder& mesh) {
  SeededRandom random(20260801);
  mesh.use(surfaces::sandstone());
  for (int i = 0; i < 160; ++i) {
    const double z = random.between(-1.5, 40.0);
    const double x = random.between(-1.0, 1.0) * (3.0 + 0.25 * (z + 2.0));
    const double size = random.between(0.05, 0.30);
    mesh.standing_box({x, 0.0, z}, {size, size * random.between(0.4, 1.2), size}, random.between(0.0, 90.0));
  }
}

}  // namespace

Scene contact_boxes() {
  MeshBuilder mesh;
  mesh.use(surfaces::concrete());
  mesh.ground({0.0, 0.0, 20.0}, 60.0);
  add_stack(mesh);
  add_hovering_row(mesh);
  add_tilted_boxes(mesh);
  add_far_towers(mesh);
  add_pebbles(mesh);
  Scene scene;
  mesh.move_into(scene);
  scene.camera = camera_looking({-0.2, 1.7, -2.2}, {0.2, 0.4, 6.0});
  scene.light_direction = sunlight(33.0, 55.0);
  return scene;
}

}  // namespace penumbra::scene
