// Casters that blend: wires on ribbons whose core is thinner than a texel of the shadow map, and puffs of
// smoke, above the ground and beside and below things that are opaque.
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/built_in_scenes.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

// AlphaPattern::wire makes a wire of a third of that width.
constexpr double kRibbonWidth = 0.06;
constexpr int kSpanPieces = 12;

Material blended(const char* name, const glm::vec3& colour, AlphaPattern pattern) {
  Material material;
  material.name = name;
  material.base_colour = colour;
  material.cut_out = CutOut{.pattern = pattern, .mode = AlphaMode::blended};
  return material;
}

struct LightAxes {
  explicit LightAxes(const glm::dvec3& light)
      : toward(-light),
        right(glm::normalize(glm::cross(glm::dvec3(0, 1, 0), toward))),
        up(glm::cross(toward, right)) {}

  glm::dvec3 toward, right, up;
};

// Adds one puff, a square that faces the light.
void add_puff(MeshBuilder& mesh, const LightAxes& light, const glm::dvec3& centre, double size) {
  mesh.use(blended("smoke", {0.35F, 0.35F, 0.36F}, AlphaPattern::smoke));
  const glm::dvec3 across = 0.5 * size * light.right, along = 0.5 * size * light.up;
  mesh.card(
      {centre - across - along, centre - across + along, centre + across + along, centre + across - along});
}

// Adds a ribbon of several pieces that faces the light and sags by a parabola.
void add_wire(MeshBuilder& mesh, const LightAxes& light, const glm::dvec3& from, const glm::dvec3& to,
              double sag) {
  mesh.use(blended("thin wire", {0.08F, 0.08F, 0.09F}, AlphaPattern::wire));
  const auto at = [&](int piece) {
    const double s = static_cast<double>(piece) / kSpanPieces;
    return from + s * (to - from) - glm::dvec3(0, 4.0 * sag * s * (1.0 - s), 0);
  };
  for (int piece = 0; piece < kSpanPieces; ++piece) {
    const glm::dvec3 a = at(piece), b = at(piece + 1);
    const glm::dvec3 across = 0.5 * kRibbonWidth * glm::normalize(glm::cross(light.toward, b - a));
    mesh.card({a - across, b - across, b + across, a + across}, {glm::length(b - a) / kRibbonWidth, 1.0});
  }
}

void add_pole(MeshBuilder& mesh, const glm::dvec3& foot, double height) {
  mesh.use(surfaces::wood());
  mesh.tube({foot, foot + glm::dvec3(0, height, 0), 0.11, 0.09, 16});
  mesh.standing_box(foot + glm::dvec3(0, height - 0.45, 0), {1.8, 0.1, 0.1});
}

// A line of poles with four wires between each two.
void add_line(MeshBuilder& mesh, const LightAxes& light) {
  constexpr int poles = 5;
  const auto foot = [](int pole) { return glm::dvec3(-3.2 + 0.3 * pole, 0.0, 1.5 + 9.0 * pole); };
  for (int pole = 0; pole < poles; ++pole) add_pole(mesh, foot(pole), 5.5);
  for (int pole = 0; pole + 1 < poles; ++pole)
    for (const double x : {-0.8, -0.35, 0.35, 0.8}) {
      const glm::dvec3 place(x, 5.16, 0.0);
      add_wire(mesh, light, foot(pole) + place, foot(pole + 1) + place, 0.35);
    }
  // Each of these wires runs from a pole down to a post: from five metres over the ground to one.
  for (int post = 0; post < 3; ++post) {
    const glm::dvec3 place(2.6, 0.0, 3.0 + 5.0 * post);
    mesh.use(surfaces::galvanised_steel());
    mesh.tube({place, place + glm::dvec3(0, 1.0, 0), 0.04, 0.04, 12});
    add_wire(mesh, light, foot(post > 1 ? 1 : 0) + glm::dvec3(0.1, 5.0, 0.0), place + glm::dvec3(0, 0.98, 0),
             0.15);
  }
}

// Puffs rise from a chimney and drift to where the sun stands, so that they shade the yard. Others hang
// low over the ground, most of them near the camera.
void add_smoke(MeshBuilder& mesh, const LightAxes& light) {
  SeededRandom random(7);
  constexpr int rising = 18, low = 26;
  for (int puff = 0; puff < rising; ++puff) {
    const double way = static_cast<double>(puff) / (rising - 1);
    const glm::dvec3 drift(-8.0 * way + random.between(-0.3, 0.3), 3.0 * way,
                           0.5 * way + random.between(-0.5, 0.5));
    add_puff(mesh, light, glm::dvec3(2.9, 3.6, 7.0) + drift, 0.7 + 1.6 * way);
  }
  for (int puff = 0; puff < low; ++puff) {
    const double farther = puff < 18 ? 0.0 : 14.0;
    const double x = random.between(-2.8, 2.2), y = random.between(0.75, 1.0), z = random.between(1.4, 6.5);
    add_puff(mesh, light, {x, y, z + farther}, random.between(0.8, 1.5));
  }
}

// Opaque things: a hut with the chimney, a table whose top stands above the low smoke, boxes, a wall.
void add_things(MeshBuilder& mesh) {
  mesh.use(surfaces::plaster(0));
  mesh.standing_box({3.6, 0.0, 7.0}, {2.6, 2.2, 3.0});
  mesh.use(surfaces::terracotta());
  mesh.gable({{3.6, 2.2, 7.0}, {3.0, 0.9, 3.4}});
  mesh.standing_box({2.9, 2.4, 7.0}, {0.4, 1.0, 0.4});
  mesh.use(surfaces::painted_wood(0));
  for (const double x : {-1.6, 0.6}) {
    mesh.standing_box({x, 1.35, 4.6}, {1.3, 0.05, 1.3});  // the smoke is below
    for (const double side : {-0.55, 0.55}) mesh.standing_box({x + side, 0.0, 4.6}, {0.07, 1.35, 1.1});
  }
  mesh.use(surfaces::concrete());
  for (int box = 0; box < 8; ++box)
    mesh.standing_box({-1.9 + 0.6 * box, 0.0, 9.0 + 2.1 * box}, {0.5, 0.3 + 0.12 * box, 0.5}, 17.0 * box);
  mesh.use(surfaces::sandstone());
  mesh.standing_box({0.5, 0.0, 30.0}, {9.0, 2.6, 0.4});
}

}  // namespace

Scene wires_and_smoke() {
  Scene scene;
  scene.light_direction = sunlight(46.0, -58.0);
  const LightAxes light(scene.light_direction);
  MeshBuilder mesh;
  mesh.use(surfaces::asphalt());
  mesh.ground({0.0, 0.0, 20.0}, 60.0);
  add_things(mesh);
  add_line(mesh, light);
  add_smoke(mesh, light);
  mesh.move_into(scene);
  scene.camera = camera_looking({0.3, 1.7, -2.6}, {0.2, 0.1, 3.6});
  return scene;
}

}  // namespace penumbra::scene
