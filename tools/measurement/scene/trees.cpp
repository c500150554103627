// Clumps of thousands of leaves: many small blockers at many heights over one receiver, sunlit gaps between.
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "scene/built_in_scenes.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

glm::dvec3 random_direction(SeededRandom& random) {
  // The height of a uniform point on the sphere is uniform (Archimedes).
  const double y = random.between(-1.0, 1.0);
  const double angle = random.between(0.0, 2.0 * std::numbers::pi);
  const double across = std::sqrt(1.0 - y * y);
  return {across * std::cos(angle), y, across * std::sin(angle)};
}

// A kite: stalk, two shoulders, tip.
void add_leaf(MeshBuilder& mesh, const glm::dvec3& stalk, SeededRandom& random) {
  const double length = random.between(0.05, 0.11);
  const glm::dvec3 along = random_direction(random);
  glm::dvec3 across = glm::cross(along, random_direction(random));
  while (glm::length(across) < 0.1) across = glm::cross(along, random_direction(random));
  const glm::dvec3 half_width = 0.28 * length * glm::normalize(across);
  const glm::dvec3 waist = stalk + 0.4 * length * along;
  mesh.quad({stalk, waist + half_width, stalk + length * along, waist - half_width});
}

struct Branch {
  glm::dvec3 from;
  glm::dvec3 direction;
  double length;
  double radius;
  int order;  // 0 is the trunk
};

// Draws the branch, then its children; `twigs` receives the places where leaves grow.
void grow(MeshBuilder& mesh, const Branch& branch, SeededRandom& random, std::vector<glm::dvec3>& twigs) {
  const glm::dvec3 end = branch.from + branch.length * branch.direction;
  mesh.tube({branch.from, end, branch.radius, 0.6 * branch.radius, branch.order == 0 ? 12 : 6});
  if (branch.order == 3) {
    twigs.push_back(end);
    return;
  }
  const int children = branch.order == 0 ? 7 : 4;
  for (int i = 0; i < children; ++i) {
    // The lowest children spring from two thirds up; all strive outward and a little upward.
    const double along = 0.66 + 0.34 * (i + 1) / children;
    glm::dvec3 direction = branch.direction + 1.1 * random_direction(random) + glm::dvec3(0, 0.25, 0);
    if (glm::length(direction) < 0.2) direction = branch.direction;
    grow(mesh,
         {branch.from + along * branch.length * branch.direction, glm::normalize(direction),
          branch.length * random.between(0.5, 0.62), 0.45 * branch.radius, branch.order + 1},
         random, twigs);
  }
}

// Leaves turn their upper side to the sky, each in its own direction.
void add_folded_leaf(MeshBuilder& mesh, const glm::dvec3& stalk, SeededRandom& random) {
  const double length = random.between(0.05, 0.11);
  const glm::dvec3 along = glm::normalize(random_direction(random) + glm::dvec3(0.0, -0.3, 0.0));
  glm::dvec3 across = glm::cross(glm::dvec3(0.0, 1.0, 0.0) + 0.8 * random_direction(random), along);
  while (glm::length(across) < 0.1) across = glm::cross(random_direction(random), along);
  mesh.leaf({stalk, along, glm::normalize(across), length, 0.56 * length});
}

struct Clump {
  glm::dvec3 centre;
  double radius;
  int leaves;
  bool folded = false;
};

void add_clump(MeshBuilder& mesh, const Clump& clump, SeededRandom& random) {
  for (int i = 0; i < clump.leaves; ++i) {
    mesh.use(surfaces::leaf(i));
    const double distance = clump.radius * std::cbrt(random.between(0.0, 1.0));
    glm::dvec3 stalk = clump.centre + distance * random_direction(random);
    stalk.y = std::max(stalk.y, 0.12);  // a leaf reaches at most 11 cm down: it stays above the ground
    if (clump.folded) {
      add_folded_leaf(mesh, stalk, random);
    } else {
      add_leaf(mesh, stalk, random);
    }
  }
}

}  // namespace

void add_tree(MeshBuilder& mesh, const Tree& tree, SeededRandom& random) {
  std::vector<glm::dvec3> twigs;
  mesh.use(surfaces::bark());
  const double trunk = 0.42 * tree.height;
  grow(mesh, {tree.foot, {0, 1, 0}, trunk, 0.035 * tree.height, 0}, random, twigs);
  const int per_twig = tree.leaves / static_cast<int>(twigs.size());
  for (const glm::dvec3& twig : twigs) {
    add_clump(mesh, {twig, 0.07 * tree.height, per_twig, tree.folded_leaves}, random);
  }
}

Scene trees() {
  MeshBuilder mesh;
  SeededRandom random(17);
  mesh.use(surfaces::lawn());
  mesh.ground({0.0, 0.0, 20.0}, 60.0);
  add_tree(mesh, {{-2.8, 0.0, 4.5}, 5.0, 9000}, random);
  add_tree(mesh, {{4.4, 0.0, 4.0}, 6.5, 12000}, random);
  add_tree(mesh, {{-5.0, 0.0, 14.0}, 7.0, 12000}, random);
  add_tree(mesh, {{2.0, 0.0, 20.0}, 6.0, 10000}, random);
  add_tree(mesh, {{8.5, 0.0, 25.0}, 8.0, 10000}, random);
  add_tree(mesh, {{-8.0, 0.0, 32.0}, 8.0, 10000}, random);
  // Bushes: clumps that reach the ground.
  for (int i = 0; i < 8; ++i) {
    add_clump(mesh, {{-1.6 + 0.9 * (i % 3) + 0.8 * i, 0.45, 3.2 + 4.0 * i}, 0.5, 500}, random);
  }
  Scene scene;
  mesh.move_into(scene);
  scene.camera = camera_looking({0.2, 1.7, -5.0}, {0.3, 1.3, 6.0});
  scene.light_direction = sunlight(42.0, 40.0);
  return scene;
}

}  // namespace penumbra::scene
