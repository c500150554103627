// Low casters in the shadow of high ones, in four places: a table under a tree, a rail before a tree, a pole
// before eaves, and a fence before another.
#include "scene/built_in_scenes.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

void add_table(MeshBuilder& mesh, const glm::dvec3& middle) {
  mesh.use(surfaces::wood());
  constexpr double kLeg = 0.05;
  for (const double x : {-0.5, 0.5})
    for (const double z : {-0.35, 0.35})
      mesh.standing_box(middle + glm::dvec3(x, 0.0, z), {kLeg, 0.72, kLeg});
  mesh.standing_box(middle + glm::dvec3(0.0, 0.72, 0.0), {1.1, 0.03, 0.8});
}

void add_rail(MeshBuilder& mesh, const glm::dvec3& from, double length) {
  mesh.use(surfaces::galvanised_steel());
  for (const double height : {0.5, 0.95})
    mesh.tube({from + glm::dvec3(0.0, height, 0.0), from + glm::dvec3(length, height, 0.0), 0.02, 0.02, 8});
  for (double along = 0.0; along <= length; along += 1.0)
    mesh.tube({from + glm::dvec3(along, 0.0, 0.0), from + glm::dvec3(along, 0.97, 0.0), 0.025, 0.025, 8});
}

// A wall along x, and a roof that stands out over it by 90 cm on both sides.
void add_eaves(MeshBuilder& mesh, const glm::dvec3& foot) {
  mesh.use(surfaces::plaster(1));
  mesh.standing_box(foot, {4.0, 3.4, 0.3});
  mesh.use(surfaces::terracotta());
  mesh.gable({foot + glm::dvec3(0.0, 3.4, 0.0), {4.4, 0.6, 2.1}});
}

}  // namespace

Scene overlaps() {
  MeshBuilder mesh;
  SeededRandom random(31);
  mesh.use(surfaces::concrete());
  mesh.ground({0.0, 0.0, 10.0}, 40.0);
  // The sun stands behind and to the right, so that shadows fall towards the camera and to its left.
  add_table(mesh, {-3.4, 0.0, 3.2});
  add_tree(mesh, {{-1.4, 0.0, 6.0}, 5.0, 9000, true}, random);
  add_rail(mesh, {2.2, 0.0, 3.6}, 4.0);
  add_tree(mesh, {{6.8, 0.0, 7.0}, 6.0, 10000, true}, random);
  add_eaves(mesh, {1.6, 0.0, 12.0});
  mesh.use(surfaces::painted_iron());
  for (int pole = 0; pole < 4; ++pole)
    mesh.tube({{-0.6 + 1.1 * pole, 0.0, 9.6}, {-0.6 + 1.1 * pole, 1.3, 9.6}, 0.03, 0.03, 8});
  add_wire_fence(mesh, {{-9.0, 0.0, 8.0}, {-4.2, 0.0, 8.0}, 1.2});
  add_wire_fence(mesh, {{-9.0, 0.0, 13.0}, {-2.6, 0.0, 13.0}, 2.6});
  Scene scene;
  mesh.move_into(scene);
  scene.camera = camera_looking({-0.6, 1.75, -1.6}, {-0.3, 0.3, 5.0});
  scene.light_direction = sunlight(40.0, 35.0);
  return scene;
}

}  // namespace penumbra::scene
