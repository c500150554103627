// A walled garden in late-morning sun, made for showing: hewn stone, leaves by the thousand, a wire fence, a
// striped awning, a laid table. Contact shadows of millimetres and leaf shadows from 6 m are in one picture.
#include "scene/built_in_scenes.h"
#include "scene/garden/pieces.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

using namespace garden;

constexpr double kWallFront = 4.0;
constexpr double kHouseLeft = 1.15;
constexpr double kTerraceLeft = -1.75;

void add_grounds(const Workshop& shop) {
  shop.mesh.use(shop.palette.turf, 1.5);
  shop.mesh.ground({0.0, 0.0, 20.0}, 60.0);
  // The bed of sand shows in the paving's joints; the gravel has one, too.
  shop.mesh.use(shop.palette.sand, 0.8);
  const double right = 9.0, near = -8.0, depth = kWallFront - near;
  shop.mesh.standing_box({0.5 * (kTerraceLeft + right), 0.0, near + 0.5 * depth},
                         {right - kTerraceLeft, 0.012, depth});
  add_paving(shop, {kTerraceLeft, right, near, 3.3});
  add_gravel(shop, {kTerraceLeft, kHouseLeft, 3.32, kWallFront - 0.02}, 2600);
  add_grass(shop, {-6.5, kTerraceLeft - 0.03, -3.0, 3.9}, 24000);
}

// Each tree has its own seed, so that one can be changed without the others.
void add_trees(MeshBuilder& mesh) {
  const auto grow = [&](const Tree& tree, std::uint32_t seed) {
    SeededRandom random(seed);
    add_tree(mesh, tree, random);
  };
  grow({{-3.3, 0.0, 1.3}, 5.4, 7800, true}, 9);
  // This tree is beside the camera and seen by its shadow alone.
  grow({{-4.7, 0.0, -5.3}, 5.6, 5000, true}, 28);
  grow({{-7.5, 0.0, 9.0}, 6.5, 9000}, 21);
  grow({{-3.8, 0.0, 11.5}, 6.5, 9000}, 22);
  grow({{-0.2, 0.0, 10.0}, 6.5, 9000}, 23);
  grow({{-11.5, 0.0, 13.0}, 6.5, 9000}, 24);
}

void add_furnishings(const Workshop& shop) {
  const Placed table{{0.35, kPaving, -1.15}, -9.0};
  add_table(shop, table);
  add_tableware(shop, {table.foot + glm::dvec3(0.0, kTableTop, 0.0), table.yaw_degrees});
  add_chair(shop, {{-0.55, kPaving, -0.75}, -62.0});
  add_chair(shop, {{0.75, kPaving, -0.20}, 24.0});
  add_bench(shop, {{-0.35, kPaving, 3.05}, 0.0});
  add_watering_can(shop, {{1.55, kPaving, 1.9}, 205.0});
  add_jar(shop, {{4.75, kPaving, 2.35}});
  add_broom(shop, {1.30, kPaving, 3.35}, {1.42, 1.62, 3.60});
}

void add_planting(const Workshop& shop) {
  add_pot(shop, {{1.72, kPaving, 3.10}, 0.46, Plant::kBox});
  add_pot(shop, {{3.60, kPaving, 3.05}, 0.40, Plant::kGeranium});
  add_pot(shop, {{4.10, kPaving, 2.75}, 0.30, Plant::kLavender});
  add_pot(shop, {{3.72, kPaving, 2.45}, 0.24, Plant::kGeranium});
  add_pot(shop, {{2.15, kPaving, -1.55}, 0.38, Plant::kLavender});
  add_creeper(shop, {{-2.6, 0.02, kWallFront - 0.05}, 2.2, 1.5, 3600});
  for (const double x : {4.75, 5.05, 5.35}) add_pot(shop, {{x, 0.95, 3.47}, 0.17, Plant::kGeranium});
}

}  // namespace

Scene garden_scene() {
  MeshBuilder mesh;
  SeededRandom random(1889);
  const Palette palette(mesh);
  const Workshop shop{mesh, palette, random};
  add_grounds(shop);
  add_stone_wall(shop, {-9.0, kHouseLeft, kWallFront, 2.15});
  add_house(shop, {kHouseLeft, 9.0, 3.6, 3.3});
  add_wire_fence(mesh, {{kTerraceLeft - 0.12, 0.0, -2.6}, {kTerraceLeft - 0.12, 0.0, 3.2}, 0.95});
  add_trees(mesh);
  add_furnishings(shop);
  add_planting(shop);
  add_festoon(shop, {{-2.6, 2.9, 1.2}, {2.4, 3.12, 3.2}, 0.35, 11});
  Scene scene;
  mesh.move_into(scene);
  scene.camera = camera_looking({0.05, 1.70, -4.7}, {0.30, 1.05, 1.0});
  scene.camera.fov_y_degrees = 46.0;
  scene.light_direction = sunlight(38.0, -126.0);
  scene.shadow_distance_metres = 32.0;
  return scene;
}

}  // namespace penumbra::scene
