// Blockers thinner than a shadow-map texel: wires of 1 to 3 cm and thin poles under a low sun.
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "scene/built_in_scenes.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

constexpr double kPostSpacing = 2.5;
constexpr double kUprightSpacing = 0.12;

void add_upright(MeshBuilder& mesh, const glm::dvec3& foot, double height, double diameter) {
  mesh.tube({foot, foot + glm::dvec3(0, height, 0), 0.5 * diameter, 0.5 * diameter, 8});
}

// A panel of crossing wires of 1 cm, 15 cm apart, at 45 degrees, as chain-link is hung.
void add_diamond_panel(MeshBuilder& mesh, const glm::dvec3& corner, const glm::dvec3& along, double length) {
  mesh.use(surfaces::galvanised_steel());
  constexpr double height = 1.5;
  const auto at = [&](double s, double y) { return corner + s * along + glm::dvec3(0, y, 0); };
  const int wires = static_cast<int>(std::ceil((length + height) / 0.15));
  for (int wire = 0; wire < wires; ++wire) {
    const double s = -height + 0.15 * wire;
    const double begin = std::max(s, 0.0), end = std::min(s + height, length);
    if (end - begin < 0.05) continue;
    mesh.tube({at(begin, begin - s), at(end, end - s), 0.005, 0.005, 6});
    mesh.tube({at(begin, height - (begin - s)), at(end, height - (end - s)), 0.005, 0.005, 6});
  }
  for (int upright = 0; upright <= 3; ++upright)
    add_upright(mesh, at(upright * length / 3.0, 0.0), 1.7, 0.06);
}

}  // namespace

void add_wire_fence(MeshBuilder& mesh, const WireFence& fence) {
  const glm::dvec3 along = fence.to - fence.from;
  const double length = glm::length(along);
  const auto at = [&](double s, double y) { return fence.from + along * (s / length) + glm::dvec3(0, y, 0); };
  mesh.use(surfaces::galvanised_steel());
  const int posts = static_cast<int>(std::round(length / kPostSpacing));
  for (int i = 0; i <= posts; ++i) add_upright(mesh, at(length * i / posts, 0.0), fence.height + 0.1, 0.08);
  constexpr double diameters[] = {0.010, 0.015, 0.020, 0.025, 0.030};
  for (std::size_t i = 0; i < std::size(diameters); ++i) {
    const double y =
        fence.height * (static_cast<double>(i) + 1.0) / static_cast<double>(std::size(diameters));
    mesh.tube({at(0.0, y), at(length, y), 0.5 * diameters[i], 0.5 * diameters[i], 8});
  }
  const int uprights = static_cast<int>(length / kUprightSpacing);
  for (int i = 1; i < uprights; ++i) {
    add_upright(mesh, at(length * i / uprights, 0.1), fence.height - 0.1, 0.010);
  }
}

void add_street_lamp(MeshBuilder& mesh, const glm::dvec3& foot, const glm::dvec3& reach) {
  mesh.use(surfaces::painted_iron());
  const glm::dvec3 top = foot + glm::dvec3(0, 6.0, 0);
  mesh.tube({foot, top, 0.07, 0.05, 12});
  mesh.tube({top, top + reach, 0.03, 0.03, 8});
  mesh.standing_box(top + reach + glm::dvec3(0, -0.12, 0), {0.4, 0.12, 0.4});
}

Scene poles_and_fence() {
  MeshBuilder mesh;
  mesh.use(surfaces::asphalt());
  mesh.ground({0.0, 0.0, 20.0}, 60.0);
  add_wire_fence(mesh, {{-3.2, 0.0, -1.0}, {-1.4, 0.0, 40.0}});
  add_diamond_panel(mesh, {2.2, 0.0, 6.0}, glm::normalize(glm::dvec3(1.0, 0.0, 0.35)), 6.0);
  for (int i = 0; i < 4; ++i) add_street_lamp(mesh, {-5.0, 0.0, 3.0 + 11.0 * i}, {1.2, 0.0, 0.0});
  mesh.use(surfaces::wood());
  // Thin poles from 1 to 6 cm, as signs and saplings' stakes have.
  for (int i = 0; i < 12; ++i) {
    add_upright(mesh, {0.6 + 0.45 * (i % 4), 0.0, 2.0 + 3.0 * i}, 1.0 + 0.2 * i, 0.010 + 0.004 * i);
  }
  Scene scene;
  mesh.move_into(scene);
  scene.camera = camera_looking({0.4, 1.7, -3.5}, {0.2, 0.7, 6.0});
  scene.light_direction = sunlight(24.0, -62.0);
  return scene;
}

}  // namespace penumbra::scene
