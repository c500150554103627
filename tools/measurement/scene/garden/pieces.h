// The pieces of the garden: metres, +Y up, every piece at its place in the scene unless a place is given.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "scene/mesh_builder.h"
#include "scene/seeded_random.h"

namespace penumbra::scene::garden {

// The garden's materials: several tints of each kind, over textures of stone, plaster, wood and sand.
struct Palette {
  explicit Palette(MeshBuilder& mesh);  // adds the textures to it

  std::array<Material, 7> wall_stone;
  Material mortar;
  Material coping;
  std::array<Material, 5> flagstone;
  Material sand;
  std::array<Material, 4> pebble;
  Material plaster;
  Material trim;  // dressed stone about the door and windows
  std::array<Material, 3> table_wood;
  std::array<Material, 2> grey_wood;
  Material bark;
  std::array<Material, 3> terracotta;
  Material soil;
  Material turf;
  std::array<Material, 4> grass;
};

// The mesh, materials and random numbers that every piece draws with.
struct Workshop {
  MeshBuilder& mesh;
  const Palette& palette;
  SeededRandom& random;

  const Material& any_of(std::span<const Material> tints) const {
    return tints[static_cast<std::size_t>(random.between(0.0, static_cast<double>(tints.size())))];
  }
};

constexpr double kPaving = 0.03;  // height of the flagstones' upper side

// A wall of hewn stones in courses of different height, with a coping, that faces -Z at z = front.
struct StoneWall {
  double left, right;  // x
  double front;        // z
  double height;
  double thickness = 0.4;
};
void add_stone_wall(const Workshop& shop, const StoneWall& wall);

// Flagstones in rows with sanded joints.
struct Paving {
  double left, right;  // x
  double near, far;    // z
};
void add_paving(const Workshop& shop, const Paving& paving);

// Pebbles strewn on a rectangle.
void add_gravel(const Workshop& shop, const Paving& area, int pebbles);

// Blades of grass on a rectangle.
void add_grass(const Workshop& shop, const Paving& area, int blades);

// The front of a house: plaster, a panelled door under a striped awning, a window with louvred shutters and a
// flower box, a lantern.
struct House {
  double left, right;  // x
  double front;        // z
  double height;
};
void add_house(const Workshop& shop, const House& house);

// A striped awning that slopes towards -Z, with a scalloped hem and two arms; top is the middle of its upper
// edge.
struct Awning {
  glm::dvec3 top;
  double width;
  double reach;
  double drop;
  int stripes;
};
void add_awning(const Workshop& shop, const Awning& awning);

// Furniture stands with its middle at foot, turned by yaw.
struct Placed {
  glm::dvec3 foot;
  double yaw_degrees = 0.0;
};
constexpr double kTableTop = 0.75;  // height above the foot
void add_table(const Workshop& shop, const Placed& place);
void add_chair(const Workshop& shop, const Placed& place);
void add_bench(const Workshop& shop, const Placed& place);

// Cups, a coffee pot, a bottle and glasses, a bowl of fruit, books: for the table's upper side, within 0.7 m
// by 0.4 m of the place.
void add_tableware(const Workshop& shop, const Placed& place);

// A big-bellied jar for oil.
void add_jar(const Workshop& shop, const Placed& place);
void add_watering_can(const Workshop& shop, const Placed& place);
void add_broom(const Workshop& shop, const glm::dvec3& foot, const glm::dvec3& top);

// A terracotta pot and what grows in it.
enum class Plant { kBox, kGeranium, kLavender };
struct Pot {
  glm::dvec3 foot;
  double height;
  Plant plant;
  double yaw_degrees = 0.0;
};
void add_pot(const Workshop& shop, const Pot& pot);

// A creeper on a wall that faces -Z at z = front, from its root to a height.
struct Creeper {
  glm::dvec3 root;
  double height;
  double spread;  // half its width
  int leaves;
};
void add_creeper(const Workshop& shop, const Creeper& creeper);

// Bulbs on a cable that sags between two points.
struct Festoon {
  glm::dvec3 from, to;
  double sag;
  int bulbs;
};
void add_festoon(const Workshop& shop, const Festoon& festoon);

}  // namespace penumbra::scene::garden
