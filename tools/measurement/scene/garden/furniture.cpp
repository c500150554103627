#include <algorithm>

#include "scene/garden/pieces.h"
#include "scene/surfaces.h"

namespace penumbra::scene::garden {
namespace {

// It places boards in the piece's own frame: x to its right, z to its back.
class Joinery {
 public:
  Joinery(const Workshop& shop, const Placed& place)
      : shop_(shop), foot_(place.foot), turned_(rotation(place.yaw_degrees)) {}

  glm::dvec3 at(const glm::dvec3& local) const { return foot_ + turned_ * local; }

  void board(const glm::dvec3& centre, const glm::dvec3& size, double pitch_degrees = 0.0) const {
    const double thinnest = std::min({size.x, size.y, size.z});
    shop_.mesh.rounded_box({{at(centre), turned_ * rotation(0.0, pitch_degrees)}, size, 0.2 * thinnest, {}});
  }

 private:
  const Workshop& shop_;
  glm::dvec3 foot_;
  glm::dmat3 turned_;
};

}  // namespace

void add_table(const Workshop& shop, const Placed& place) {
  constexpr double length = 1.56, width = 0.86, thickness = 0.032;
  constexpr int boards = 6;
  const Joinery joinery(shop, place);
  for (int i = 0; i < boards; ++i) {
    shop.mesh.use(shop.any_of(shop.palette.table_wood), 0.8);
    const double z = -0.5 * width + (i + 0.5) * width / boards;
    joinery.board({0.0, kTableTop - 0.5 * thickness, z}, {length, thickness, width / boards - 0.010});
  }
  shop.mesh.use(shop.palette.table_wood[2], 0.8);
  for (const double z : {-0.36, 0.36}) joinery.board({0.0, 0.665, z}, {length - 0.20, 0.09, 0.025});
  for (const double x : {-0.68, 0.68}) {
    joinery.board({x, 0.665, 0.0}, {0.025, 0.09, 0.70});
    for (const double z : {-0.35, 0.35}) joinery.board({x, 0.355, z}, {0.07, 0.71, 0.07});
  }
}

void add_chair(const Workshop& shop, const Placed& place) {
  const Joinery joinery(shop, place);
  Material paint = surfaces::painted_wood(3);
  paint.name = "chair paint";
  paint.base_colour = {0.62F, 0.66F, 0.62F};
  shop.mesh.use(paint);
  for (const double x : {-0.20, 0.20}) {
    joinery.board({x, 0.22, -0.19}, {0.035, 0.44, 0.035});
    joinery.board({x, 0.22, 0.19}, {0.035, 0.44, 0.035});
    joinery.board({x, 0.68, 0.235}, {0.035, 0.54, 0.03}, 11.0);
    joinery.board({x, 0.20, 0.0}, {0.022, 0.03, 0.36});
  }
  for (int i = 0; i < 6; ++i) joinery.board({0.0, 0.448, -0.195 + 0.076 * i}, {0.46, 0.018, 0.058});
  for (int i = 0; i < 5; ++i) {
    const double y = 0.56 + 0.088 * i;
    joinery.board({0.0, y, 0.195 + 0.195 * (y - 0.44)}, {0.38, 0.055, 0.014}, 11.0);
  }
}

void add_bench(const Workshop& shop, const Placed& place) {
  const Joinery joinery(shop, place);
  for (const double x : {-0.68, 0.0, 0.68}) {
    shop.mesh.use(shop.palette.grey_wood[1]);
    joinery.board({x, 0.21, -0.20}, {0.06, 0.42, 0.06});
    joinery.board({x, 0.21, 0.20}, {0.06, 0.42, 0.06});
    joinery.board({x, 0.40, 0.0}, {0.05, 0.06, 0.46});
    joinery.board({x, 0.66, 0.255}, {0.05, 0.56, 0.04}, 12.0);
  }
  for (int i = 0; i < 5; ++i) {
    shop.mesh.use(shop.any_of(shop.palette.grey_wood));
    joinery.board({0.0, 0.442, -0.20 + 0.10 * i}, {1.50, 0.024, 0.080});
  }
  for (int i = 0; i < 4; ++i) {
    const double y = 0.58 + 0.105 * i;
    shop.mesh.use(shop.any_of(shop.palette.grey_wood));
    joinery.board({0.0, y, 0.212 + 0.212 * (y - 0.44)}, {1.50, 0.075, 0.020}, 12.0);
  }
}

}  // namespace penumbra::scene::garden
