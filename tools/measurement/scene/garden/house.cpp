#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "scene/garden/pieces.h"
#include "scene/surfaces.h"

namespace penumbra::scene::garden {
namespace {

struct Opening {
  double left, right;  // x
  double sill, head;   // y
};
constexpr Opening kDoor{2.15, 3.10, 0.0, 2.12};
constexpr Opening kWindow{4.55, 5.55, 0.95, 2.15};
constexpr double kRecess = 0.22;
constexpr double kThickness = 0.35;

// The panel reaches from (left, bottom) to (right, top), with its face at z and its back behind it.
void add_panel(const Workshop& shop, const Opening& area, double z, double thickness) {
  shop.mesh.standing_box({0.5 * (area.left + area.right), area.sill, z + 0.5 * thickness},
                         {area.right - area.left, area.head - area.sill, thickness});
}

void add_front(const Workshop& shop, const House& house) {
  shop.mesh.use(shop.palette.plaster, 2.4);
  const auto panel = [&](double left, double right, double bottom, double top) {
    add_panel(shop, {left, right, bottom, top}, house.front, kThickness);
  };
  panel(house.left, kDoor.left, 0.0, house.height);
  panel(kDoor.left, kDoor.right, kDoor.head, house.height);
  panel(kDoor.right, kWindow.left, 0.0, house.height);
  panel(kWindow.left, kWindow.right, 0.0, kWindow.sill);
  panel(kWindow.left, kWindow.right, kWindow.head, house.height);
  panel(kWindow.right, house.right, 0.0, house.height);
  // These panels are the rest of the house, behind.
  panel(house.left, house.left + kThickness, 0.0, house.height);
  shop.mesh.standing_box({0.5 * (house.left + house.right), 0.0, house.front + kThickness + 1.8},
                         {house.right - house.left, house.height, 3.6});
  // A plinth of dressed stone.
  shop.mesh.use(shop.palette.trim, 0.9);
  for (const auto& [left, right] :
       {std::pair(house.left, kDoor.left - 0.17), std::pair(kDoor.right + 0.17, house.right)}) {
    const int blocks = std::max(1, static_cast<int>(std::lround((right - left) / 0.8)));
    for (int i = 0; i < blocks; ++i) {
      const double width = (right - left) / blocks;
      shop.mesh.rounded_box({{{left + (i + 0.5) * width, 0.17, house.front + 0.02}, glm::dmat3(1.0)},
                             {width - 0.008, 0.34, 0.12},
                             0.012,
                             {}});
    }
  }
}

// Dressed stones about an opening: two jambs of blocks, a lintel.
void add_surround(const Workshop& shop, const House& house, const Opening& opening) {
  constexpr double width = 0.16;
  shop.mesh.use(shop.palette.trim, 0.9);
  const int blocks = static_cast<int>(std::lround((opening.head - opening.sill) / 0.35));
  const double height = (opening.head - opening.sill) / blocks;
  for (int i = 0; i < blocks; ++i) {
    const double extra = i % 2 == 0 ? 0.05 : 0.0;
    for (const double side : {-1.0, 1.0}) {
      const double edge = side < 0 ? opening.left : opening.right;
      shop.mesh.rounded_box(
          {{{edge + side * 0.5 * (width + extra), opening.sill + (i + 0.5) * height, house.front + 0.06},
            glm::dmat3(1.0)},
           {width + extra, height - 0.006, 0.20},
           0.010,
           {}});
    }
  }
  const double middle = 0.5 * (opening.left + opening.right),
               span = opening.right - opening.left + 2 * width + 0.1;
  shop.mesh.rounded_box(
      {{{middle, opening.head + 0.11, house.front + 0.055}, glm::dmat3(1.0)}, {span, 0.22, 0.22}, 0.014, {}});
}

void add_door(const Workshop& shop, const House& house) {
  const double face = house.front + kRecess - 0.05;
  const double width = kDoor.right - kDoor.left;
  Material paint = surfaces::painted_wood(0);
  paint.name = "door paint";
  paint.base_colour = {0.085F, 0.20F, 0.22F};
  paint.normal_texture = shop.palette.table_wood[0].normal_texture;
  shop.mesh.use(paint);
  constexpr int boards = 6;
  for (int i = 0; i < boards; ++i) {
    const double x = kDoor.left + (i + 0.5) * width / boards;
    shop.mesh.rounded_box({{{x, 0.5 * kDoor.head + 0.01, face + 0.02}, glm::dmat3(1.0)},
                           {width / boards - 0.006, kDoor.head - 0.02, 0.04},
                           0.006,
                           {}});
  }
  for (const double y : {0.35, 1.05, 1.80}) {
    shop.mesh.rounded_box({{{kDoor.left + 0.5 * width, y, face - 0.01}, glm::dmat3(1.0)},
                           {width - 0.08, 0.11, 0.03},
                           0.006,
                           {}});
  }
  shop.mesh.use(surfaces::painted_iron());
  shop.mesh.bar({{{kDoor.right - 0.10, 0.98, face - 0.01},
                  {kDoor.right - 0.10, 0.98, face - 0.06},
                  {kDoor.right - 0.20, 0.98, face - 0.065}},
                 0.009,
                 8});
  shop.mesh.use(shop.palette.flagstone[1]);
  shop.mesh.rounded_box({{{0.5 * (kDoor.left + kDoor.right), 0.085, house.front - 0.12}, glm::dmat3(1.0)},
                         {width + 0.36, 0.15, 0.60},
                         0.02,
                         {}});
  shop.mesh.use(shop.palette.mortar);
  add_panel(shop, {kDoor.left, kDoor.right, 0.0, kDoor.head}, house.front + kRecess + 0.01, 0.05);
}

// A louvred shutter, hinged beside the window and laid open against the wall.
void add_shutter(const Workshop& shop, double middle, double front) {
  constexpr double width = 0.50, stile = 0.06, depth = 0.035;
  const double bottom = kWindow.sill, top = kWindow.head, z = front - 0.045;
  Material paint = surfaces::painted_wood(0);
  paint.name = "shutter paint";
  paint.base_colour = {0.16F, 0.30F, 0.33F};
  shop.mesh.use(paint);
  const auto bar = [&](double x, double y, double w, double h) {
    shop.mesh.rounded_box({{{x, y, z}, glm::dmat3(1.0)}, {w, h, depth}, 0.005, {}});
  };
  for (const double side : {-1.0, 1.0})
    bar(middle + side * 0.5 * (width - stile), 0.5 * (bottom + top), stile, top - bottom);
  for (const double y : {bottom + 0.04, 0.5 * (bottom + top), top - 0.04})
    bar(middle, y, width - 2 * stile, 0.08);
  constexpr int slats = 24;
  for (int i = 0; i < slats; ++i) {
    const double y = bottom + 0.1 + (top - bottom - 0.2) * (i + 0.5) / slats;
    if (std::abs(y - 0.5 * (bottom + top)) < 0.06) continue;
    shop.mesh.box({{middle, y, z}, rotation(0.0, -40.0)}, {width - 2 * stile, 0.008, 0.045});
  }
}

void add_window(const Workshop& shop, const House& house) {
  const double width = kWindow.right - kWindow.left, middle = 0.5 * (kWindow.left + kWindow.right);
  shop.mesh.use(surfaces::dark_glass());
  add_panel(shop, kWindow, house.front + kRecess, 0.02);
  shop.mesh.use(surfaces::painted_wood(3));
  const double z = house.front + kRecess - 0.02;
  const auto bar = [&](double x, double y, double w, double h) {
    shop.mesh.box({{x, y, z}, glm::dmat3(1.0)}, {w, h, 0.05});
  };
  const double height = kWindow.head - kWindow.sill, centre = 0.5 * (kWindow.head + kWindow.sill);
  for (const double x : {kWindow.left + 0.03, middle, kWindow.right - 0.03}) bar(x, centre, 0.06, height);
  for (const double y : {kWindow.sill + 0.03, kWindow.sill + height / 3.0, kWindow.sill + 2.0 * height / 3.0,
                         kWindow.head - 0.03}) {
    bar(middle, y, width, y == kWindow.sill + 0.03 || y == kWindow.head - 0.03 ? 0.06 : 0.025);
  }
  for (const double side : {-1.0, 1.0})
    add_shutter(shop, middle + side * (0.5 * width + 0.16 + 0.27), house.front);
  shop.mesh.use(shop.palette.trim);
  shop.mesh.rounded_box({{{middle, kWindow.sill - 0.04, house.front - 0.01}, glm::dmat3(1.0)},
                         {width + 0.3, 0.08, 0.28},
                         0.012,
                         {}});
}

void add_lantern(const Workshop& shop, const House& house) {
  const glm::dvec3 hook{3.62, 2.25, house.front - 0.26};
  shop.mesh.use(surfaces::painted_iron());
  shop.mesh.bar({{{hook.x, 2.25, house.front},
                  {hook.x, 2.36, house.front - 0.14},
                  {hook.x, 2.33, house.front - 0.24},
                  hook},
                 0.009,
                 8});
  const Pose pose{hook - glm::dvec3(0.0, 0.30, 0.0), glm::dmat3(1.0)};
  shop.mesh.lathe(
      {pose, {{0.0, 0.22}, {0.10, 0.20}, {0.11, 0.215}, {0.03, 0.29}, {0.015, 0.30}, {0.0, 0.30}}, 6});
  shop.mesh.lathe({pose, {{0.0, -0.02}, {0.06, -0.01}, {0.065, 0.0}, {0.0, 0.005}}, 6});
  Material glass = surfaces::plaster(4);
  glass.name = "lantern glass";
  glass.roughness = 0.2F;
  glass.translucency = 0.4F;
  shop.mesh.use(glass);
  shop.mesh.lathe({pose, {{0.0, 0.002}, {0.055, 0.004}, {0.085, 0.20}, {0.0, 0.202}}, 6});
}

// Half a pipe, wider at its lower end; up is its ridge's side.
void add_barrel_tile(const Workshop& shop, const glm::dvec3& low, const glm::dvec3& high,
                     const glm::dvec3& up) {
  constexpr int facets = 8;
  constexpr double thickness = 0.014;
  const glm::dvec3 across = glm::normalize(glm::cross(up, high - low));
  const auto at = [&](int facet, bool lower, bool outer) {
    const double angle = std::numbers::pi * facet / facets;
    const double radius = (lower ? 0.095 : 0.080) - (outer ? 0.0 : thickness);
    return (lower ? low : high) + radius * (std::cos(angle) * across + std::sin(angle) * up);
  };
  for (int i = 0; i < facets; ++i) {
    shop.mesh.quad({at(i, true, true), at(i, false, true), at(i + 1, false, true), at(i + 1, true, true)});
    shop.mesh.quad(
        {at(i + 1, true, false), at(i + 1, false, false), at(i, false, false), at(i, true, false)});
    shop.mesh.quad({at(i, true, true), at(i + 1, true, true), at(i + 1, true, false), at(i, true, false)});
  }
}

// Barrel tiles: columns of overlapping half rounds down a slope of 28 degrees, over an eave of 40 cm.
void add_roof(const Workshop& shop, const House& house) {
  constexpr double slope = 28.0, length = 4.6, overhang = 0.42, spacing = 0.21, course = 0.38;
  const double rise = std::sin(glm::radians(slope)), run = std::cos(glm::radians(slope));
  const glm::dvec3 up_slope{0.0, rise, run};
  const double left = house.left - 0.18;
  const glm::dvec3 eave{0.0, house.height - overhang * rise / run + 0.05, house.front - overhang};
  const glm::dmat3 tilted = rotation(0.0, -slope);
  shop.mesh.use(shop.palette.terracotta[1], 1.2);
  const double width = house.right - left;
  shop.mesh.box({eave + glm::dvec3(left + 0.5 * width, 0.0, 0.0) + 0.5 * length * up_slope, tilted},
                {width, 0.04, length});
  shop.mesh.use(shop.palette.grey_wood[1]);
  for (double x = left + 0.12; x < house.right; x += 0.55) {  // rafters' ends
    shop.mesh.box({eave + glm::dvec3(x, -0.075, 0.0) + 0.35 * up_slope, tilted}, {0.08, 0.11, 0.70});
  }
  const glm::dvec3 tile_normal{0.0, run, -rise};
  for (double x = left + 0.08; x < house.right; x += spacing) {
    for (double s = -0.06; s < length - course; s += course) {
      const glm::dvec3 low = eave + glm::dvec3(x + shop.random.between(-0.006, 0.006), 0.0, 0.0) +
                             s * up_slope + (0.045 + shop.random.between(0.0, 0.008)) * tile_normal;
      shop.mesh.use(shop.any_of(shop.palette.terracotta), 1.2);
      add_barrel_tile(shop, low, low + (course + 0.07) * up_slope - 0.014 * tile_normal, tile_normal);
    }
  }
  shop.mesh.use(shop.palette.plaster, 2.4);  // the gable towards the garden wall
  const double back = house.front + kThickness + 3.6;
  shop.mesh.triangle({house.left, house.height, house.front}, {house.left, house.height, back},
                     {house.left, house.height + (back - house.front) * rise / run - 0.05, back});
}

}  // namespace

void add_awning(const Workshop& shop, const Awning& awning) {
  constexpr int bends = 6;
  const double step = awning.width / awning.stripes, left = awning.top.x - 0.5 * awning.width;
  // The cloth sags by 5 cm between its upper edge and the bar at its lower one.
  const auto at = [&](double x, double t) {
    return glm::dvec3(x, awning.top.y - awning.drop * t - 0.05 * 4.0 * t * (1.0 - t),
                      awning.top.z - awning.reach * t);
  };
  for (int stripe = 0; stripe < awning.stripes; ++stripe) {
    const double a = left + stripe * step, b = a + step;
    shop.mesh.use(surfaces::cloth(stripe % 2));
    for (int i = 0; i < bends; ++i) {
      const double t = static_cast<double>(i) / bends, u = static_cast<double>(i + 1) / bends;
      shop.mesh.quad({at(b, t), at(b, u), at(a, u), at(a, t)});
    }
    // A scallop: half a round under a straight hem.
    const glm::dvec3 edge = at(0.5 * (a + b), 1.0);
    const auto rim = [&](int k) {
      const double angle = std::numbers::pi * k / 8.0;
      return glm::dvec3(edge.x + 0.5 * step * std::cos(angle), edge.y - 0.09 - 0.5 * step * std::sin(angle),
                        edge.z - 0.004);
    };
    shop.mesh.quad({rim(8), {a, edge.y, edge.z}, {b, edge.y, edge.z}, rim(0)});
    for (int k = 1; k < 8; ++k) shop.mesh.triangle(rim(0), rim(k), rim(k + 1));
  }
  shop.mesh.use(surfaces::painted_iron());
  const double bar_y = awning.top.y - awning.drop;
  shop.mesh.bar({{at(left, 1.0), at(left + awning.width, 1.0)}, 0.012, 8});
  for (const double x : {left + 0.06, left + awning.width - 0.06}) {
    shop.mesh.bar(
        {{{x, bar_y, awning.top.z - awning.reach + 0.01}, {x, bar_y - 0.12, awning.top.z}}, 0.011, 8});
  }
}

void add_house(const Workshop& shop, const House& house) {
  add_front(shop, house);
  add_surround(shop, house, kDoor);
  add_surround(shop, house, kWindow);
  add_door(shop, house);
  add_window(shop, house);
  add_lantern(shop, house);
  add_roof(shop, house);
  add_awning(shop, {{0.5 * (kDoor.left + kDoor.right), 2.78, house.front - 0.01}, 2.1, 1.15, 0.46, 10});
}

}  // namespace penumbra::scene::garden
