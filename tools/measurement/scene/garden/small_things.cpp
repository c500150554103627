// The small things on the garden's table and about it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/garden/pieces.h"
#include "scene/surfaces.h"

namespace penumbra::scene::garden {
namespace {

Material glazed(const char* name, const glm::vec3& colour, float roughness = 0.25F) {
  Material material;
  material.name = name;
  material.base_colour = colour;
  material.roughness = roughness;
  return material;
}

// A frame on a piece of furniture: x to its right, z to its back, y above its foot.
class Setting {
 public:
  Setting(const Workshop& shop, const Placed& place)
      : shop_(shop), foot_(place.foot), turned_(rotation(place.yaw_degrees)) {}

  Pose at(const glm::dvec3& local, double yaw = 0.0, double pitch = 0.0, double roll = 0.0) const {
    return {foot_ + turned_ * local, turned_ * rotation(yaw, pitch, roll)};
  }
  void turned_shape(const Pose& pose, std::vector<std::array<double, 2>> profile, int sides = 32) const {
    shop_.mesh.lathe({pose, std::move(profile), sides});
  }
  MeshBuilder& mesh() const { return shop_.mesh; }

 private:
  const Workshop& shop_;
  glm::dvec3 foot_;
  glm::dmat3 turned_;
};

void add_cup(const Setting& setting, const glm::dvec3& place, double handle_degrees) {
  const Pose saucer = setting.at(place, handle_degrees);
  setting.turned_shape(
      saucer, {{0.0, 0.002}, {0.04, 0.002}, {0.072, 0.012}, {0.074, 0.015}, {0.045, 0.007}, {0.0, 0.006}});
  Pose cup = saucer;
  cup.centre.y += 0.007;
  setting.turned_shape(cup, {{0.0, 0.0},
                             {0.024, 0.0},
                             {0.026, 0.005},
                             {0.038, 0.030},
                             {0.042, 0.060},
                             {0.040, 0.062},
                             {0.038, 0.060},
                             {0.034, 0.030},
                             {0.022, 0.012},
                             {0.0, 0.009}});
  std::vector<glm::dvec3> handle;
  for (int i = 0; i <= 8; ++i) {
    const double angle = std::numbers::pi * (i / 8.0 - 0.5);
    handle.push_back(cup.centre + cup.rotation * glm::dvec3(0.036 + 0.022 * std::cos(angle),
                                                            0.034 + 0.018 * std::sin(angle), 0.0));
  }
  setting.mesh().bar({handle, 0.0040, 8});
}

void add_coffee(const Setting& setting, const glm::dvec3& place) {
  setting.mesh().use(glazed("coffee", {0.035F, 0.018F, 0.009F}, 0.15F));
  setting.turned_shape(setting.at(place), {{0.0, 0.045}, {0.0375, 0.046}, {0.0, 0.051}});
}

void add_pot_of_coffee(const Setting& setting, const glm::dvec3& place) {
  const Pose pot = setting.at(place, 150.0);
  setting.mesh().use(glazed("enamel", {0.075F, 0.16F, 0.30F}, 0.2F));
  setting.turned_shape(pot, {{0.0, 0.0},
                             {0.068, 0.0},
                             {0.074, 0.008},
                             {0.070, 0.060},
                             {0.052, 0.150},
                             {0.046, 0.185},
                             {0.050, 0.190},
                             {0.050, 0.194},
                             {0.030, 0.212},
                             {0.010, 0.216},
                             {0.008, 0.224},
                             {0.014, 0.234},
                             {0.010, 0.242},
                             {0.0, 0.244}});
  const auto at = [&](double x, double y) { return pot.centre + pot.rotation * glm::dvec3(x, y, 0.0); };
  setting.mesh().bar({{at(0.060, 0.075), at(0.095, 0.105), at(0.108, 0.145), at(0.122, 0.178)}, 0.0095, 12});
  setting.mesh().bar(
      {{at(-0.050, 0.170), at(-0.090, 0.172), at(-0.106, 0.140), at(-0.098, 0.090), at(-0.068, 0.055)},
       0.0065,
       10});
}

void add_bottle(const Setting& setting, const glm::dvec3& place) {
  setting.mesh().use(glazed("bottle glass", {0.035F, 0.075F, 0.030F}, 0.1F));
  setting.turned_shape(setting.at(place), {{0.0, 0.0},
                                           {0.034, 0.0},
                                           {0.037, 0.004},
                                           {0.037, 0.185},
                                           {0.032, 0.208},
                                           {0.017, 0.235},
                                           {0.0145, 0.250},
                                           {0.0145, 0.282},
                                           {0.0165, 0.284},
                                           {0.0165, 0.294},
                                           {0.012, 0.296}});
  setting.mesh().use(glazed("label", {0.72F, 0.66F, 0.52F}, 0.8F));
  setting.turned_shape(setting.at(place),
                       {{0.0365, 0.060}, {0.0378, 0.060}, {0.0378, 0.145}, {0.0365, 0.145}});
  setting.mesh().use(glazed("cork", {0.45F, 0.30F, 0.17F}, 0.9F));
  setting.turned_shape(setting.at(place),
                       {{0.0, 0.28}, {0.0118, 0.28}, {0.0118, 0.307}, {0.010, 0.309}, {0.0, 0.309}}, 16);
}

void add_tumbler(const Setting& setting, const glm::dvec3& place) {
  Material glass = glazed("tumbler", {0.55F, 0.63F, 0.62F}, 0.08F);
  glass.translucency = 0.6F;
  setting.mesh().use(glass);
  setting.turned_shape(setting.at(place), {{0.0, 0.0},
                                           {0.027, 0.0},
                                           {0.030, 0.003},
                                           {0.036, 0.095},
                                           {0.0345, 0.096},
                                           {0.0335, 0.094},
                                           {0.028, 0.012},
                                           {0.0, 0.010}});
}

void add_fruit(const Setting& setting, const glm::dvec3& place, double radius) {
  std::vector<std::array<double, 2>> profile{{0.0, 0.06 * radius}};
  for (int i = 1; i < 10; ++i) {
    const double angle = std::numbers::pi * i / 10.0;
    profile.push_back({radius * std::sin(angle), radius * (1.0 - 0.95 * std::cos(angle))});
  }
  profile.push_back({0.0, 1.86 * radius});
  setting.turned_shape(setting.at(place), profile, 20);
}

void add_bowl_of_fruit(const Setting& setting, const glm::dvec3& place) {
  setting.mesh().use(glazed("bowl glaze", {0.60F, 0.57F, 0.50F}, 0.3F));
  setting.turned_shape(setting.at(place),
                       {{0.0, 0.0},
                        {0.055, 0.0},
                        {0.058, 0.010},
                        {0.100, 0.035},
                        {0.135, 0.080},
                        {0.134, 0.083},
                        {0.130, 0.081},
                        {0.095, 0.042},
                        {0.055, 0.022},
                        {0.0, 0.018}},
                       40);
  const Material orange = glazed("orange", {0.72F, 0.24F, 0.025F}, 0.45F),
                 lemon = glazed("lemon", {0.78F, 0.56F, 0.06F}, 0.4F),
                 apple = glazed("apple", {0.46F, 0.06F, 0.045F}, 0.3F),
                 pear = glazed("green apple", {0.34F, 0.45F, 0.08F}, 0.3F);
  struct Fruit {
    const Material& material;
    double x, y, z, radius;
  };
  for (const Fruit& fruit :
       {Fruit{orange, -0.045, 0.028, -0.035, 0.038}, Fruit{apple, 0.045, 0.028, -0.030, 0.037},
        Fruit{lemon, 0.0, 0.028, 0.050, 0.033}, Fruit{pear, -0.065, 0.045, 0.045, 0.034},
        Fruit{orange, 0.062, 0.045, 0.045, 0.037}, Fruit{apple, 0.0, 0.082, 0.0, 0.038}}) {
    setting.mesh().use(fruit.material);
    add_fruit(setting, place + glm::dvec3(fruit.x, fruit.y, fruit.z), fruit.radius);
  }
  setting.mesh().use(lemon);  // two that lie on the table
  add_fruit(setting, place + glm::dvec3(0.19, 0.0, -0.07), 0.032);
  setting.mesh().use(apple);
  add_fruit(setting, place + glm::dvec3(0.155, 0.0, -0.135), 0.037);
}

void add_books(const Setting& setting, const glm::dvec3& place) {
  struct Book {
    glm::vec3 cover;
    double yaw, thickness, width, length;
    const char* name;
  };
  double y = place.y;
  for (const Book& book : {Book{{0.30F, 0.06F, 0.05F}, 12.0, 0.036, 0.165, 0.235, "red cover"},
                           Book{{0.08F, 0.16F, 0.26F}, -7.0, 0.024, 0.150, 0.220, "blue cover"},
                           Book{{0.55F, 0.42F, 0.17F}, 24.0, 0.018, 0.120, 0.185, "yellow cover"}}) {
    const double board = 0.003;
    setting.mesh().use(glazed("paper", {0.74F, 0.69F, 0.58F}, 0.9F));
    setting.mesh().box(setting.at({place.x, y + 0.5 * book.thickness, place.z}, book.yaw),
                       {book.width - 0.006, book.thickness - 2 * board, book.length - 0.010});
    setting.mesh().use(glazed(book.name, book.cover, 0.6F));
    for (const double side : {board * 0.5, book.thickness - 0.5 * board}) {
      setting.mesh().box(setting.at({place.x, y + side, place.z}, book.yaw),
                         {book.width, board, book.length});
    }
    const Pose middle = setting.at({place.x, y + 0.5 * book.thickness, place.z}, book.yaw);
    setting.mesh().box(
        {middle.centre - middle.rotation * glm::dvec3(0.5 * book.width, 0.0, 0.0), middle.rotation},
        {0.004, book.thickness, book.length});
    y += book.thickness + 0.0002;
  }
  // Spectacles lie on top.
  setting.mesh().use(surfaces::painted_iron());
  for (const double x : {-0.032, 0.032}) {
    std::vector<glm::dvec3> rim;
    for (int i = 0; i <= 16; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 16.0;
      rim.push_back(setting
                        .at({place.x + x + 0.024 * std::cos(angle), y + 0.021 + 0.019 * std::sin(angle),
                             place.z - 0.03})
                        .centre);
    }
    setting.mesh().bar({rim, 0.0016, 6});
    setting.mesh().bar({{setting.at({place.x + 1.75 * x, y + 0.026, place.z - 0.03}).centre,
                         setting.at({place.x + 1.7 * x, y + 0.003, place.z + 0.08}).centre},
                        0.0016,
                        6});
  }
}

void add_plate(const Setting& setting, const glm::dvec3& place) {
  setting.turned_shape(setting.at(place),
                       {{0.0, 0.002},
                        {0.060, 0.002},
                        {0.104, 0.016},
                        {0.106, 0.019},
                        {0.102, 0.020},
                        {0.066, 0.009},
                        {0.0, 0.007}},
                       40);
}

// A striped cloth across the table that hangs over its front and back edges.
void add_runner(const Setting& setting, double x, double half_depth) {
  constexpr double width = 0.36, thickness = 0.0024;
  constexpr int stripes = 9;
  for (int i = 0; i < stripes; ++i) {
    Material linen = surfaces::cloth(i % 2 == 0 ? 1 : 3);
    setting.mesh().use(linen);
    const double middle = x + width * ((i + 0.5) / stripes - 0.5), each = width / stripes;
    setting.mesh().box(setting.at({middle, 0.5 * thickness, 0.0}), {each, thickness, 2.0 * half_depth});
    for (const double side : {-1.0, 1.0}) {
      setting.mesh().box(setting.at({middle, thickness - 0.10, side * (half_depth + 0.5 * thickness)}),
                         {each, 0.20, thickness});
    }
  }
}

void add_vase(const Setting& setting, const glm::dvec3& place, SeededRandom& random) {
  setting.mesh().use(glazed("vase", {0.36F, 0.47F, 0.50F}, 0.25F));
  setting.turned_shape(setting.at(place), {{0.0, 0.0},
                                           {0.034, 0.0},
                                           {0.038, 0.006},
                                           {0.050, 0.050},
                                           {0.044, 0.090},
                                           {0.026, 0.120},
                                           {0.030, 0.142},
                                           {0.027, 0.142},
                                           {0.022, 0.120},
                                           {0.0, 0.100}});
  for (int i = 0; i < 9; ++i) {  // daisies
    const double angle = 2.4 * i, reach = 0.02 + 0.008 * i;
    const glm::dvec3 root = setting.at(place + glm::dvec3(0.0, 0.12, 0.0)).centre;
    const glm::dvec3 head =
        root + glm::dvec3(reach * std::cos(angle), 0.17 - 0.008 * i + random.between(0.0, 0.02),
                          reach * std::sin(angle));
    setting.mesh().use(surfaces::leaf(0));
    setting.mesh().bar({{root, glm::mix(root, head, 0.6) + glm::dvec3(0, 0.02, 0), head}, 0.0019, 5});
    const glm::dvec3 facing = glm::normalize(head - root + glm::dvec3(0.0, 0.1, -0.12));
    const glm::dvec3 side = glm::normalize(glm::cross(facing, glm::dvec3(0.0, 0.0, 1.0)));
    const glm::dvec3 other = glm::cross(facing, side);
    Material petal = surfaces::cloth(1);
    petal.name = "petal";
    petal.base_colour = {0.78F, 0.76F, 0.70F};
    setting.mesh().use(petal);
    for (int k = 0; k < 11; ++k) {
      const double turn = 2.0 * std::numbers::pi * k / 11.0;
      const glm::dvec3 along = std::cos(turn) * side + std::sin(turn) * other;
      setting.mesh().leaf({head + 0.004 * along, along, glm::cross(facing, along), 0.020, 0.008, 8.0});
    }
    setting.mesh().use(glazed("flower heart", {0.75F, 0.48F, 0.04F}, 0.9F));
    setting.mesh().bar({{head - 0.002 * facing, head + 0.005 * facing}, 0.006, 8});
  }
}

}  // namespace

void add_tableware(const Workshop& shop, const Placed& place) {
  const Setting setting(shop, place);
  const Material porcelain = glazed("porcelain", {0.76F, 0.74F, 0.70F}, 0.15F);
  const glm::dvec3 left_cup{-0.40, 0.0, -0.20}, right_cup{0.27, 0.0, -0.28};
  for (const auto& [cup, handle] : {std::pair(left_cup, 35.0), std::pair(right_cup, -30.0)}) {
    shop.mesh.use(porcelain);
    add_cup(setting, cup, handle);
    add_coffee(setting, cup + glm::dvec3(0.0, 0.007, 0.0));
  }
  shop.mesh.use(porcelain);
  add_plate(setting, {0.02, 0.003, -0.24});
  add_plate(setting, {-0.22, 0.0, 0.24});
  add_runner(setting, 0.02, 0.435);
  add_pot_of_coffee(setting, {-0.18, 0.0, 0.02});
  add_bottle(setting, {0.33, 0.0, 0.20});
  add_tumbler(setting, {0.26, 0.0, -0.02});
  add_tumbler(setting, {0.47, 0.0, 0.06});
  add_bowl_of_fruit(setting, {0.50, 0.0, -0.18});
  add_books(setting, {-0.52, 0.0, 0.13});
  add_vase(setting, {0.02, 0.003, 0.10}, shop.random);
}

void add_jar(const Workshop& shop, const Placed& place) {
  const Setting setting(shop, place);
  shop.mesh.use(shop.palette.terracotta[2], 1.1);
  setting.turned_shape(setting.at({}),
                       {{0.0, 0.0},
                        {0.15, 0.0},
                        {0.17, 0.03},
                        {0.27, 0.26},
                        {0.315, 0.46},
                        {0.30, 0.60},
                        {0.22, 0.73},
                        {0.165, 0.79},
                        {0.165, 0.82},
                        {0.20, 0.85},
                        {0.20, 0.875},
                        {0.17, 0.88},
                        {0.14, 0.82},
                        {0.14, 0.74},
                        {0.0, 0.70}},
                       48);
}

void add_watering_can(const Workshop& shop, const Placed& place) {
  const Setting setting(shop, place);
  shop.mesh.use(surfaces::galvanised_steel());
  setting.turned_shape(setting.at({}), {{0.0, 0.0},
                                        {0.118, 0.0},
                                        {0.120, 0.010},
                                        {0.116, 0.012},
                                        {0.112, 0.250},
                                        {0.116, 0.254},
                                        {0.116, 0.262},
                                        {0.108, 0.262},
                                        {0.106, 0.20},
                                        {0.0, 0.20}});
  const auto at = [&](double x, double y) { return setting.at({x, y, 0.0}).centre; };
  shop.mesh.bar({{at(0.105, 0.05), at(0.19, 0.13), at(0.36, 0.34)}, 0.018, 12});
  shop.mesh.tube({at(0.355, 0.333), at(0.40, 0.388), 0.02, 0.055, 20});
  shop.mesh.bar(
      {{at(-0.11, 0.23), at(-0.17, 0.24), at(-0.20, 0.18), at(-0.18, 0.10), at(-0.115, 0.06)}, 0.010, 8});
  shop.mesh.bar({{at(-0.10, 0.26), at(-0.05, 0.35), at(0.04, 0.37), at(0.10, 0.27)}, 0.009, 8});
}

void add_broom(const Workshop& shop, const glm::dvec3& foot, const glm::dvec3& top) {
  const glm::dvec3 along = glm::normalize(top - foot);
  shop.mesh.use(shop.palette.grey_wood[0]);
  shop.mesh.bar({{foot + 0.28 * along, top}, 0.013, 10});
  Material straw;
  straw.name = "straw";
  straw.base_colour = {0.52F, 0.38F, 0.17F};
  shop.mesh.use(straw);
  const glm::dvec3 side = glm::normalize(glm::cross(along, glm::dvec3(0.0, 0.0, 1.0)));
  const glm::dvec3 depth = glm::cross(along, side);
  for (int i = 0; i < 70; ++i) {
    const double x = shop.random.between(-1.0, 1.0), z = shop.random.between(-1.0, 1.0);
    const glm::dvec3 low =
        foot + 0.13 * x * side + 0.035 * z * depth + shop.random.between(0.0, 0.02) * along;
    shop.mesh.bar({{low, foot + 0.33 * along + 0.02 * x * side + 0.012 * z * depth}, 0.0022, 5});
  }
}

void add_festoon(const Workshop& shop, const Festoon& festoon) {
  constexpr int parts = 3;  // parts of the cable between two bulbs
  const int steps = parts * (festoon.bulbs + 1);
  const auto at = [&](int i) {
    const double t = static_cast<double>(i) / steps;
    return glm::mix(festoon.from, festoon.to, t) - glm::dvec3(0.0, 4.0 * festoon.sag * t * (1.0 - t), 0.0);
  };
  std::vector<glm::dvec3> cable;
  for (int i = 0; i <= steps; ++i) cable.push_back(at(i));
  shop.mesh.use(surfaces::rubber());
  shop.mesh.bar({cable, 0.005, 6});
  Material bulb = glazed("bulb", {0.74F, 0.68F, 0.52F}, 0.1F);
  bulb.translucency = 0.5F;
  for (int i = 1; i <= festoon.bulbs; ++i) {
    const Pose pose{at(parts * i) - glm::dvec3(0.0, 0.13, 0.0), glm::dmat3(1.0)};
    shop.mesh.use(surfaces::rubber());
    shop.mesh.lathe({pose, {{0.0, 0.072}, {0.016, 0.074}, {0.017, 0.128}, {0.0, 0.132}}, 10});
    shop.mesh.use(bulb);
    shop.mesh.lathe(
        {pose,
         {{0.0, 0.0}, {0.020, 0.006}, {0.030, 0.026}, {0.027, 0.048}, {0.014, 0.074}, {0.0, 0.076}},
         14});
  }
}

}  // namespace penumbra::scene::garden
