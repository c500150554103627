// The cover of the garden's ground: flagstones, gravel, grass.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "scene/garden/pieces.h"

namespace penumbra::scene::garden {
namespace {

void add_flagstone(const Workshop& shop, const glm::dvec3& middle, double width, double depth) {
  constexpr double thickness = 0.05;
  std::array<glm::dvec3, 8> shift{};
  for (glm::dvec3& corner : shift) {
    corner = {shop.random.between(-0.008, 0.008), shop.random.between(-0.0015, 0.0015),
              shop.random.between(-0.008, 0.008)};
  }
  const double top = kPaving - shop.random.between(0.0, 0.004);
  shop.mesh.use(shop.any_of(shop.palette.flagstone), 0.9);
  shop.mesh.rounded_box({{{middle.x, top - 0.5 * thickness + 0.02, middle.z}, glm::dmat3(1.0)},
                         {width, 0.04, depth},
                         0.007,
                         shift});
}

// A pebble is an egg of 20 faces with smooth normals, turned at random.
void add_pebble(const Workshop& shop, const glm::dvec3& place, double size) {
  const double height = size * shop.random.between(0.35, 0.6);
  const double wide = 0.5 * size;
  const glm::dmat3 turned = rotation(shop.random.between(0.0, 360.0), shop.random.between(-15.0, 15.0),
                                     shop.random.between(-15.0, 15.0));
  shop.mesh.lathe(
      {{place, turned},
       {{0.0, -0.3 * height}, {0.8 * wide, 0.0}, {0.85 * wide, 0.45 * height}, {0.0, 0.8 * height}},
       5});
}

}  // namespace

void add_paving(const Workshop& shop, const Paving& paving) {
  constexpr double joint = 0.016;
  double z = paving.near;
  while (z < paving.far - 0.05) {
    double depth = shop.random.between(0.42, 0.62);
    if (paving.far - z - depth < 0.25) depth = paving.far - z;
    double x = paving.left;
    while (x < paving.right) {
      double width = shop.random.between(0.45, 1.05);
      if (paving.right - x - width < 0.3) width = paving.right - x;
      add_flagstone(shop, {x + 0.5 * width, 0.0, z + 0.5 * depth}, width - joint, depth - joint);
      x += width;
    }
    z += depth;
  }
}

void add_gravel(const Workshop& shop, const Paving& area, int pebbles) {
  for (int i = 0; i < pebbles; ++i) {
    const glm::dvec3 place{shop.random.between(area.left, area.right), shop.random.between(0.004, 0.022),
                           shop.random.between(area.near, area.far)};
    shop.mesh.use(shop.any_of(shop.palette.pebble));
    add_pebble(shop, place, shop.random.between(0.018, 0.045));
  }
}

void add_grass(const Workshop& shop, const Paving& area, int blades) {
  for (int i = 0; i < blades; ++i) {
    const glm::dvec3 root{shop.random.between(area.left, area.right), 0.0,
                          shop.random.between(area.near, area.far)};
    const double angle = shop.random.between(0.0, 2.0 * std::numbers::pi);
    const glm::dvec3 across{std::cos(angle), 0.0, std::sin(angle)};
    const glm::dvec3 lean = shop.random.between(0.0, 0.06) * glm::dvec3(-across.z, 0.0, across.x);
    const double height = shop.random.between(0.05, 0.13);
    const double width = shop.random.between(0.004, 0.008);
    const glm::dvec3 knee = root + glm::dvec3(0.0, 0.6 * height, 0.0) + 0.3 * lean;
    const glm::dvec3 tip = root + glm::dvec3(0.0, height, 0.0) + lean;
    shop.mesh.use(shop.any_of(shop.palette.grass));
    const glm::dvec3 half = 0.5 * width * across;
    shop.mesh.quad({root - half, root + half, knee + 0.8 * half, knee - 0.8 * half});
    shop.mesh.triangle(knee - 0.8 * half, knee + 0.8 * half, tip);
  }
}

}  // namespace penumbra::scene::garden
