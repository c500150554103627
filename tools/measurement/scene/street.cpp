// A street of 45 m: houses with ledges, awnings and balcony rails, lamps, cables, cars and trees, all at
// once.
#include <cmath>

#include "scene/built_in_scenes.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

constexpr double kKerb = 0.12;     // height of the pavement
constexpr double kRoadHalf = 3.6;  // half the width of the road
constexpr double kFacade = 6.4;    // distance of the facades from the middle

// `side` is -1 left of the camera, +1 right.
struct House {
  double side;
  double z;
  double width;  // along the street
  double height;
  int tint;  // tint of the plaster
};

void add_balcony(MeshBuilder& mesh, const glm::dvec3& centre, double side) {
  mesh.use(surfaces::concrete());
  mesh.standing_box(centre, {1.0, 0.12, 2.4});
  mesh.use(surfaces::painted_iron());
  const double front = centre.x - side * 0.46;
  const auto rail = [&](const glm::dvec3& from, const glm::dvec3& to) {
    mesh.tube({from, to, 0.01, 0.01, 6});
  };
  for (int i = 0; i <= 18; ++i) {
    const double z = centre.z - 1.15 + 2.3 * i / 18.0;
    rail({front, centre.y + 0.12, z}, {front, centre.y + 1.1, z});
  }
  mesh.tube(
      {{front, centre.y + 1.1, centre.z - 1.2}, {front, centre.y + 1.1, centre.z + 1.2}, 0.02, 0.02, 8});
}

void add_house(MeshBuilder& mesh, const House& house) {
  const double depth = 8.0;
  mesh.use(surfaces::plaster(house.tint));
  mesh.standing_box({house.side * (kFacade + 0.5 * depth), 0.0, house.z}, {depth, house.height, house.width});
  mesh.standing_box({house.side * (kFacade + 0.5 * depth - 0.2), house.height, house.z},
                    {depth + 0.4, 0.3, house.width});  // the cornice overhangs by 40 cm
  mesh.use(surfaces::sandstone());
  const double out = house.side * (kFacade - 0.1);
  const int storeys = static_cast<int>(std::ceil((house.height - 1.5 - 3.6) / 3.0));
  const int windows = static_cast<int>(std::ceil((house.width - 1.2 - 0.6) / 2.2));
  for (int storey = 0; storey < storeys; ++storey) {
    for (int window = 0; window < windows; ++window) {
      const double y = 3.6 + 3.0 * storey;
      const double z = house.z - 0.5 * house.width + 1.2 + 2.2 * window;
      mesh.standing_box({out, y, z}, {0.2, 0.08, 1.3});        // sill
      mesh.standing_box({out, y + 1.7, z}, {0.2, 0.12, 1.5});  // lintel
    }
  }
  // An awning on the ground floor that slopes to the street.
  mesh.use(surfaces::cloth(house.tint));
  const glm::dvec3 awning{house.side * (kFacade - 0.75), 2.7, house.z};
  mesh.box({awning, rotation(0.0, 0.0, -house.side * -18.0)}, {1.5, 0.04, 0.6 * house.width});
  add_balcony(mesh, {house.side * (kFacade - 0.5), 3.4, house.z + 0.2 * house.width}, house.side);
}

void add_car(MeshBuilder& mesh, double x, double z, int tint) {
  mesh.use(surfaces::car_paint(tint));
  mesh.standing_box({x, 0.28, z}, {1.75, 0.55, 4.2});
  mesh.standing_box({x, 0.83, z - 0.2}, {1.5, 0.55, 2.1});
  mesh.use(surfaces::rubber());
  for (const double side : {-0.78, 0.78}) {
    for (const double axle : {-1.3, 1.3}) {
      mesh.tube({{x + side - 0.1, 0.31, z + axle}, {x + side + 0.1, 0.31, z + axle}, 0.31, 0.31, 20});
    }
  }
}

// A cable of 2 cm across the street, hung as a parabola 60 cm deep.
void add_cable(MeshBuilder& mesh, double z) {
  const auto at = [z](int i) {
    const double s = i / 6.0 - 1.0;
    return glm::dvec3(kFacade * s, 6.5 - 0.6 * (1.0 - s * s), z + 0.8 * s);
  };
  mesh.use(surfaces::painted_iron());
  for (int i = 0; i < 12; ++i) mesh.tube({at(i), at(i + 1), 0.01, 0.01, 6});
  mesh.standing_box({0.0, 5.55, z}, {0.35, 0.35, 0.35}, 45.0);  // the lantern it carries
}

}  // namespace

Scene street() {
  MeshBuilder mesh;
  SeededRandom random(4);
  mesh.use(surfaces::asphalt());
  mesh.ground({0.0, 0.0, 20.0}, 60.0);
  for (const double side : {-1.0, 1.0}) {
    mesh.use(surfaces::concrete());
    mesh.standing_box({side * 0.5 * (kRoadHalf + kFacade + 8.0), 0.0, 20.0},
                      {kFacade + 8.0 - kRoadHalf, kKerb, 56.0});
    double z = -2.0;
    for (int i = 0; i < 5; ++i) {
      const double width = random.between(7.0, 9.5);
      add_house(mesh,
                {side, z + 0.5 * width, width,
                 side > 0 ? random.between(5.0, 7.5) : random.between(7.0, 12.0), i + (side > 0 ? 2 : 0)});
      z += width + (i % 2 == 1 ? 1.8 : 0.0);
    }
    for (int i = 0; i < 4; ++i) {
      add_street_lamp(mesh, {side * 4.0, kKerb, 1.5 + 11.0 * i + 5.0 * (side > 0)}, {-side * 1.2, 0.0, 0.0});
    }
  }
  for (const double z : {5.0, 14.0, 23.0, 34.0}) add_cable(mesh, z);
  add_car(mesh, 2.4, 5.0, 0);
  add_car(mesh, 2.4, 12.5, 1);
  add_car(mesh, -2.4, 9.0, 2);
  add_car(mesh, 2.4, 26.0, 3);
  add_tree(mesh, {{-4.6, kKerb, 12.5}, 4.6, 5000}, random);
  add_tree(mesh, {{4.7, kKerb, 17.0}, 4.8, 5000}, random);
  add_tree(mesh, {{-4.6, kKerb, 30.0}, 5.0, 5000}, random);
  Scene scene;
  mesh.move_into(scene);
  scene.camera = camera_looking({-0.6, 1.7, -3.5}, {0.2, 1.6, 8.0});
  scene.light_direction = sunlight(40.0, 58.0);
  return scene;
}

}  // namespace penumbra::scene
