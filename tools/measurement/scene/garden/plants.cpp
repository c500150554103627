#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "scene/garden/pieces.h"
#include "scene/surfaces.h"

namespace penumbra::scene::garden {
namespace {

glm::dvec3 any_direction(SeededRandom& random) {
  const double y = random.between(-1.0, 1.0), angle = random.between(0.0, 2.0 * std::numbers::pi);
  const double across = std::sqrt(1.0 - y * y);
  return {across * std::cos(angle), y, across * std::sin(angle)};
}

// Returns a leaf whose upper side faces `facing` as far as its direction permits.
Leaf leaf_facing(const glm::dvec3& stalk, const glm::dvec3& along, const glm::dvec3& facing, double length,
                 double width) {
  const glm::dvec3 across = glm::normalize(glm::cross(facing, along));
  return {stalk, along, across, length, width};
}

Material flower(const char* name, const glm::vec3& colour) {
  Material material;
  material.name = name;
  material.base_colour = colour;
  material.roughness = 0.7F;
  material.translucency = 0.3F;
  return material;
}

void add_pot_body(const Workshop& shop, const Pot& pot) {
  const double h = pot.height, r = 0.52 * h;
  shop.mesh.use(shop.any_of(shop.palette.terracotta), 0.8);
  shop.mesh.lathe({{pot.foot, rotation(pot.yaw_degrees)},
                   {{0.0, 0.0},
                    {0.62 * r, 0.0},
                    {0.66 * r, 0.02 * h},
                    {0.92 * r, 0.78 * h},
                    {1.02 * r, 0.80 * h},
                    {1.04 * r, 0.98 * h},
                    {1.00 * r, h},
                    {0.90 * r, h},
                    {0.88 * r, 0.90 * h},
                    {0.0, 0.89 * h}},
                   36});
  shop.mesh.use(shop.palette.soil);
  shop.mesh.lathe({{pot.foot, glm::dmat3(1.0)},
                   {{0.0, 0.85 * h}, {0.87 * r, 0.89 * h}, {0.5 * r, 0.93 * h}, {0.0, 0.94 * h}},
                   24});
}

// A clipped ball: a thick shell of small leaves about a dark core.
void add_box_bush(const Workshop& shop, const glm::dvec3& soil, double size) {
  const double radius = 0.62 * size;
  const glm::dvec3 middle = soil + glm::dvec3(0.0, 0.9 * radius, 0.0);
  shop.mesh.use(surfaces::bark());
  shop.mesh.bar({{soil - glm::dvec3(0, 0.02, 0), middle}, 0.02, 8});
  for (int i = 0; i < 2600; ++i) {
    const glm::dvec3 out = any_direction(shop.random);
    const glm::dvec3 stalk = middle + radius * shop.random.between(0.72, 1.0) * out;
    if (stalk.y < soil.y + 0.02) continue;
    const glm::dvec3 along = glm::normalize(out + 0.9 * any_direction(shop.random));
    shop.mesh.use(surfaces::leaf(i % 3 == 0 ? 0 : 2));
    shop.mesh.leaf(leaf_facing(
        stalk, along, glm::normalize(out + glm::dvec3(0.0, 0.5, 0.0) + 0.1 * any_direction(shop.random)),
        shop.random.between(0.028, 0.042), 0.020));
  }
}

void add_blossom(const Workshop& shop, const glm::dvec3& head, double radius, const Material& colour) {
  shop.mesh.use(colour);
  for (int i = 0; i < 34; ++i) {
    glm::dvec3 out = any_direction(shop.random);
    out.y = std::abs(out.y) - 0.25;
    out = glm::normalize(out);
    const glm::dvec3 along = glm::normalize(glm::cross(out, any_direction(shop.random)));
    shop.mesh.leaf(leaf_facing(head + radius * out - 0.008 * along, along, out, 0.020, 0.017));
  }
}

void add_geranium(const Workshop& shop, const glm::dvec3& soil, double size, const Material& colour) {
  for (int i = 0; i < 70; ++i) {
    const double angle = 2.399963 * i, reach = size * 0.55 * std::sqrt((i + 0.5) / 70.0);
    const glm::dvec3 out{std::cos(angle), 0.0, std::sin(angle)};
    const double height = size * (0.55 - 0.5 * reach / size) * shop.random.between(0.6, 1.2);
    const glm::dvec3 tip = soil + reach * out + glm::dvec3(0.0, height, 0.0);
    shop.mesh.use(surfaces::leaf(3));
    shop.mesh.bar(
        {{soil + 0.2 * reach * out, glm::mix(soil, tip, 0.6) + glm::dvec3(0.0, 0.03, 0.0), tip}, 0.0025, 5});
    shop.mesh.use(surfaces::leaf(i));
    const glm::dvec3 facing =
        glm::normalize(out * 0.8 + glm::dvec3(0.0, 1.0, 0.0) + 0.4 * any_direction(shop.random));
    const glm::dvec3 along = glm::normalize(out - glm::dot(out, facing) * facing);
    const double length = shop.random.between(0.055, 0.085);
    shop.mesh.leaf(leaf_facing(tip - 0.3 * length * along, along, facing, length, 1.05 * length));
  }
  for (int i = 0; i < 9; ++i) {
    const double angle = 2.399963 * i + 1.0, reach = size * 0.42 * std::sqrt((i + 0.5) / 9.0);
    const glm::dvec3 head = soil + glm::dvec3(reach * std::cos(angle), size * shop.random.between(0.62, 0.85),
                                              reach * std::sin(angle));
    shop.mesh.use(surfaces::leaf(0));
    shop.mesh.bar(
        {{soil + glm::dvec3(0.4 * (head.x - soil.x), 0.0, 0.4 * (head.z - soil.z)), head}, 0.0028, 5});
    add_blossom(shop, head, 0.032, colour);
  }
}

void add_lavender(const Workshop& shop, const glm::dvec3& soil, double size) {
  const Material bloom = flower("lavender", {0.24F, 0.15F, 0.42F});
  for (int i = 0; i < 190; ++i) {
    const double angle = 2.399963 * i, reach = size * 0.62 * std::sqrt((i + 0.5) / 190.0);
    const glm::dvec3 out{std::cos(angle), 0.0, std::sin(angle)};
    const glm::dvec3 tip =
        soil + reach * out +
        glm::dvec3(0.0, (1.25 - 0.5 * reach / size) * size * shop.random.between(0.75, 1.05), 0.0);
    const glm::dvec3 along = glm::normalize(tip - soil);
    shop.mesh.use(shop.palette.grass[2]);
    shop.mesh.bar({{soil + 0.25 * reach * out, glm::mix(soil, tip, 0.7) - 0.01 * out, tip}, 0.0016, 5});
    for (int k = 0; k < 4; ++k) {  // narrow leaves low on the stalk
      const glm::dvec3 side = glm::normalize(along + 1.2 * any_direction(shop.random));
      shop.mesh.use(shop.palette.grass[k % 2 == 0 ? 0 : 2]);
      shop.mesh.leaf(leaf_facing(soil + 0.25 * reach * out + shop.random.between(0.05, 0.5) * (tip - soil),
                                 side, glm::normalize(glm::cross(side, any_direction(shop.random))), 0.055,
                                 0.006));
    }
    shop.mesh.use(bloom);
    for (int k = 0; k < 9; ++k) {
      const glm::dvec3 side = glm::normalize(along + 0.9 * any_direction(shop.random));
      shop.mesh.leaf(leaf_facing(tip - 0.008 * k * along, side,
                                 glm::normalize(glm::cross(side, any_direction(shop.random))), 0.013, 0.007));
    }
  }
}

}  // namespace

void add_pot(const Workshop& shop, const Pot& pot) {
  add_pot_body(shop, pot);
  const glm::dvec3 soil = pot.foot + glm::dvec3(0.0, 0.92 * pot.height, 0.0);
  switch (pot.plant) {
    case Plant::kBox:
      add_box_bush(shop, soil, pot.height);
      break;
    case Plant::kGeranium:
      add_geranium(shop, soil, 0.9 * pot.height + 0.10, flower("geranium", {0.62F, 0.035F, 0.045F}));
      break;
    case Plant::kLavender:
      add_lavender(shop, soil, pot.height);
      break;
  }
}

void add_creeper(const Workshop& shop, const Creeper& creeper) {
  constexpr int stems = 14, joints = 14;
  const int per_joint = creeper.leaves / (stems * joints);
  for (int stem = 0; stem < stems; ++stem) {
    const double drift = creeper.spread * (2.0 * (stem + 0.5) / stems - 1.0);
    const double reach = creeper.height * shop.random.between(0.55, 1.0);
    std::vector<glm::dvec3> path;
    for (int i = 0; i <= joints; ++i) {
      const double t = static_cast<double>(i) / joints;
      const double sway = i == 0 ? 0.0 : shop.random.between(-0.06, 0.06);
      path.push_back(creeper.root + glm::dvec3(drift * std::pow(t, 0.7) + sway, reach * t,
                                               -shop.random.between(0.0, 0.05) * t));
    }
    shop.mesh.use(surfaces::bark());
    shop.mesh.bar({path, 0.006, 6});
    for (int i = 1; i <= joints; ++i) {
      for (int k = 0; k < per_joint; ++k) {
        glm::dvec3 stalk =
            path[i] + glm::dvec3(shop.random.between(-0.16, 0.16), shop.random.between(-0.14, 0.14),
                                 -shop.random.between(0.03, 0.13));
        stalk.y = std::max(stalk.y, 0.12);  // a leaf hangs at most 11 cm down
        glm::dvec3 along =
            glm::normalize(glm::dvec3(shop.random.between(-0.7, 0.7), -1.0, -shop.random.between(0.0, 0.5)));
        const glm::dvec3 facing = glm::normalize(glm::dvec3(shop.random.between(-0.5, 0.5), 0.45, -1.0));
        along = glm::normalize(along - 0.9 * glm::dot(along, facing) * facing);
        const double length = shop.random.between(0.06, 0.11);
        shop.mesh.use(surfaces::leaf(k + stem));
        shop.mesh.leaf(leaf_facing(stalk, along, facing, length, 0.85 * length));
      }
    }
  }
}

}  // namespace penumbra::scene::garden
