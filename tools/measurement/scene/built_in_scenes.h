// The built-in scenes, one file each, and the objects that several of them share.
#pragma once

#include <glm/vec3.hpp>

#include "scene/mesh_builder.h"
#include "scene/scene.h"
#include "scene/seeded_random.h"

namespace penumbra::scene {

Scene contact_boxes();
Scene poles_and_fence();
Scene trees();
Scene slabs();
Scene colonnade();
Scene street();
Scene garden_scene();
Scene wires_and_smoke();
Scene overlaps();
Scene valley_5();
Scene valley_20();
Scene valley_20_clouds();
Scene valley_45();

// A deciduous tree: a trunk, three orders of branches, and leaves of 5 to 11 cm about the twigs' ends.
struct Tree {
  glm::dvec3 foot;
  double height = 6.0;
  int leaves = 5000;
  bool folded_leaves = false;  // four triangles each, bent along the rib; else a flat kite of two
};
void add_tree(MeshBuilder& mesh, const Tree& tree, SeededRandom& random);

// A fence of posts, five horizontal wires of 1, 1.5, 2, 2.5 and 3 cm from the bottom up, and upright wires of
// 1 cm every 12 cm.
struct WireFence {
  glm::dvec3 from;
  glm::dvec3 to;
  double height = 1.6;
};
void add_wire_fence(MeshBuilder& mesh, const WireFence& fence);

// A street lamp of 6 m: a pole of 12 cm, an arm towards reach, a lamp box at its end.
void add_street_lamp(MeshBuilder& mesh, const glm::dvec3& foot, const glm::dvec3& reach);

}  // namespace penumbra::scene
