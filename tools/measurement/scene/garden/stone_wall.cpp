#include <algorithm>

#include "scene/garden/pieces.h"

namespace penumbra::scene::garden {
namespace {

constexpr double kJoint = 0.014;

std::array<glm::dvec3, 8> hewn(SeededRandom& random, const glm::dvec3& amount) {
  std::array<glm::dvec3, 8> shift{};
  for (glm::dvec3& corner : shift) {
    for (int axis = 0; axis < 3; ++axis) corner[axis] = random.between(-1.0, 1.0) * amount[axis];
  }
  return shift;
}

void add_course(const Workshop& shop, const StoneWall& wall, double bottom, double height) {
  double x = wall.left - shop.random.between(0.0, 0.2);
  while (x < wall.right) {
    double width = height * shop.random.between(1.1, 2.6);
    if (wall.right - x - width < 0.12) width = wall.right - x;
    const double out = shop.random.between(0.0, 0.035);  // distance in front of the wall's face
    const double depth = 0.16;
    shop.mesh.use(shop.any_of(shop.palette.wall_stone), 0.7);
    shop.mesh.rounded_box({{{x + 0.5 * width, bottom + 0.5 * height, wall.front - out + 0.5 * depth},
                            rotation(0.0, shop.random.between(-1.5, 1.5), shop.random.between(-0.8, 0.8))},
                           {width - kJoint, height - kJoint, depth},
                           std::min(0.028, 0.2 * height),
                           hewn(shop.random, {0.014, 0.010, 0.014})});
    x += width;
  }
}

void add_coping(const Workshop& shop, const StoneWall& wall) {
  double x = wall.left;
  while (x < wall.right) {
    const double width = std::min(shop.random.between(0.55, 0.85), wall.right - x);
    if (width < 0.1) break;
    shop.mesh.use(shop.palette.coping, 0.8);
    shop.mesh.rounded_box({{{x + 0.5 * width, wall.height + 0.05, wall.front + 0.5 * wall.thickness},
                            rotation(shop.random.between(-0.6, 0.6), 0.0, shop.random.between(-0.5, 0.5))},
                           {width - 0.01, 0.10, wall.thickness + 0.14},
                           0.022,
                           hewn(shop.random, {0.006, 0.006, 0.012})});
    x += width;
  }
}

}  // namespace

void add_stone_wall(const Workshop& shop, const StoneWall& wall) {
  const double core = wall.thickness - 0.03;
  shop.mesh.use(shop.palette.mortar, 0.6);
  shop.mesh.standing_box({0.5 * (wall.left + wall.right), 0.0, wall.front + 0.03 + 0.5 * core},
                         {wall.right - wall.left, wall.height, core});
  double bottom = 0.0;
  while (bottom < wall.height - 0.02) {
    double height = shop.random.between(0.12, 0.24);
    if (wall.height - bottom - height < 0.1) height = wall.height - bottom;
    add_course(shop, wall, bottom, height);
    bottom += height;
  }
  add_coping(shop, wall);
}

}  // namespace penumbra::scene::garden
