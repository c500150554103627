// A low slab under a high slab: two blockers at different depths over one receiver, whose penumbrae overlap.
// A single average blocker depth is wrong here.
#include "scene/built_in_scenes.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

// A slab on four legs that stand within its corners.
struct Table {
  glm::dvec3 centre;  // on the ground
  glm::dvec3 size;    // of the slab
  double underside;   // its height above the ground
  double leg = 0.12;
};

void add_table(MeshBuilder& mesh, const Table& table) {
  const glm::dvec3& size = table.size;
  mesh.standing_box(table.centre + glm::dvec3(0, table.underside, 0), size);
  for (const double x : {-0.5, 0.5}) {
    for (const double z : {-0.5, 0.5}) {
      const glm::dvec3 foot =
          table.centre + glm::dvec3(x * (size.x - table.leg), 0, z * (size.z - table.leg));
      mesh.standing_box(foot, {table.leg, table.underside, table.leg});
    }
  }
}

}  // namespace

Scene slabs() {
  MeshBuilder mesh;
  mesh.use(surfaces::concrete());
  mesh.ground({0.0, 0.0, 20.0}, 60.0);
  // Near: a bench under a canopy, so that the canopy's soft edge crosses the bench and its hard shadow.
  mesh.use(surfaces::wood());
  add_table(mesh, {{-0.6, 0.0, 3.0}, {2.4, 0.08, 1.0}, 0.55, 0.08});
  mesh.use(surfaces::painted_wood(3));
  add_table(mesh, {{1.6, 0.0, 5.2}, {4.5, 0.15, 3.6}, 3.6, 0.14});
  mesh.use(surfaces::sandstone());
  // Middle: slabs upon slabs, three layers.
  add_table(mesh, {{-4.5, 0.0, 11.0}, {3.0, 0.1, 3.0}, 0.8});
  add_table(mesh, {{-3.6, 0.0, 11.8}, {4.0, 0.1, 4.0}, 2.2});
  add_table(mesh, {{-2.4, 0.0, 13.0}, {5.0, 0.2, 5.0}, 6.0, 0.2});
  mesh.use(surfaces::concrete());
  // Far: a footbridge over a road deck, and a slatted roof whose gaps are lit.
  mesh.standing_box({0.0, 1.0, 26.0}, {30.0, 0.3, 4.0});
  mesh.standing_box({0.0, 8.0, 28.0}, {40.0, 0.4, 3.0});
  for (const double x : {-14.0, -7.0, 7.0, 14.0}) mesh.standing_box({x, 0.0, 28.9}, {0.5, 8.0, 0.5});
  for (const double x : {-12.0, 0.0, 12.0}) mesh.standing_box({x, 0.0, 26.0}, {0.6, 1.0, 2.0});
  mesh.use(surfaces::wood());
  for (int i = 0; i < 16; ++i) mesh.standing_box({7.0, 2.8, 9.0 + 0.45 * i}, {4.0, 0.05, 0.25});
  for (const double x : {5.2, 8.8}) {
    mesh.standing_box({x, 2.65, 12.4}, {0.12, 0.15, 7.4});
    for (const double z : {8.9, 15.9}) mesh.standing_box({x, 0.0, z}, {0.12, 2.65, 0.12});
  }
  Scene scene;
  mesh.move_into(scene);
  scene.camera = camera_looking({-0.2, 1.7, -2.4}, {0.2, 0.8, 6.0});
  scene.light_direction = sunlight(48.0, 35.0);
  return scene;
}

}  // namespace penumbra::scene
