// A valley between mountains, 10 km x 10 km: ridges cast shadows over kilometres, and trees near the camera
// cast shadows that the cascades draw.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "scene/built_in_scenes.h"
#include "scene/surfaces.h"

namespace penumbra::scene {
namespace {

constexpr double kSide = 10000.0;  // metres
constexpr int kCells = 640;
constexpr double kCell = kSide / kCells;
constexpr double kEyeHeight = 25.0;
constexpr double kSeenDistance = 9000.0;
constexpr double kShadowDistance = 150.0;

double eased(double t) {
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

// Returns a number in [-1, 1] for a corner of the lattice.
double lattice(std::int64_t x, std::int64_t z, std::uint32_t seed) {
  auto bits = static_cast<std::uint32_t>(x) * 0x8DA6B343U ^ static_cast<std::uint32_t>(z) * 0xD8163841U ^
              seed * 0xCB1AB31FU;
  bits ^= bits >> 15U;
  bits *= 0x2C1B3C6DU;
  bits ^= bits >> 12U;
  bits *= 0x297A2D39U;
  bits ^= bits >> 15U;
  return static_cast<double>(bits) * (2.0 / 4294967295.0) - 1.0;
}

// Returns value noise in [-1, 1], with two continuous derivatives (Perlin, "Improving noise", 2002, for its
// fade).
double noise(double x, double z, std::uint32_t seed) {
  const double column = std::floor(x), row = std::floor(z);
  const double u = eased(x - column), v = eased(z - row);
  const auto i = static_cast<std::int64_t>(column), j = static_cast<std::int64_t>(row);
  const double low = std::lerp(lattice(i, j, seed), lattice(i + 1, j, seed), u);
  const double high = std::lerp(lattice(i, j + 1, seed), lattice(i + 1, j + 1, seed), u);
  return std::lerp(low, high, v);
}

// Returns ridges where the noise changes its sign, in [0, 1]; they have several sizes, each half of the one
// before.
double ridges(double x, double z) {
  double sum = 0.0, strength = 0.5, size = 1700.0;
  for (std::uint32_t octave = 0; octave < 6; ++octave) {
    const double ridge = 1.0 - std::abs(noise(x / size, z / size, 20 + octave));
    sum += strength * ridge * ridge;
    strength *= 0.5;
    size *= 0.5;
  }
  return sum;
}

double axis_of_valley(double z) {
  return 500.0 * noise(z / 3600.0, 0.5, 1);
}

double height(double x, double z) {
  const double beside = std::abs(x - axis_of_valley(z));
  const double rise = eased(std::clamp((beside - 300.0) / 3200.0, 0.0, 1.0));
  const double floor = 12.0 * noise(x / 260.0, z / 260.0, 7) + 3.0 * noise(x / 60.0, z / 60.0, 8);
  return floor + rise * (420.0 + 900.0 * ridges(x, z));
}

std::vector<double> heights_of_ground() {
  std::vector<double> heights;
  heights.reserve(static_cast<std::size_t>(kCells + 1) * (kCells + 1));
  for (int z = 0; z <= kCells; ++z)
    for (int x = 0; x <= kCells; ++x)
      heights.push_back(height(kCell * x - 0.5 * kSide, kCell * z - 0.5 * kSide));
  return heights;
}

// Returns the height of the ground's triangles, on which a tree stands: they are lower than height() between
// their corners.
double ground_at(const std::vector<double>& heights, double x, double z) {
  const double column = (x + 0.5 * kSide) / kCell, row = (z + 0.5 * kSide) / kCell;
  const auto i = static_cast<std::size_t>(column), j = static_cast<std::size_t>(row);
  const double u = column - std::floor(column), v = row - std::floor(row);
  const auto corner = [&](std::size_t right, std::size_t up) {
    return heights[(j + up) * (kCells + 1) + i + right];
  };
  // The triangles' common edge runs from the first corner to the last.
  const double nearest = corner(0, 0), last = corner(1, 1);
  if (v >= u) return nearest + v * (corner(0, 1) - nearest) + u * (last - corner(0, 1));
  return nearest + u * (corner(1, 0) - nearest) + v * (last - corner(1, 0));
}

struct Grove {
  double nearest;  // metres from the camera
  double farthest;
  int trees;
  int leaves;
};

void add_grove(MeshBuilder& mesh, const std::vector<double>& heights, const glm::dvec3& eye,
               const Grove& grove, SeededRandom& random) {
  for (int i = 0; i < grove.trees; ++i) {
    const double distance = random.between(grove.nearest, grove.farthest);
    const double side = random.between(-0.55, 0.55);  // share of the way ahead
    const double x = eye.x + side * distance, z = eye.z + distance;
    add_tree(mesh, {{x, ground_at(heights, x, z) - 0.1, z}, random.between(5.0, 11.0), grove.leaves}, random);
  }
}

Scene valley(double sun_elevation) {
  const std::vector<double> heights = heights_of_ground();
  MeshBuilder mesh;
  mesh.use(surfaces::lawn());
  mesh.heights(glm::dvec2(-0.5 * kSide), kCell, kCells, heights);
  const double x = axis_of_valley(-4300.0) - 1200.0, z = -4300.0;
  const glm::dvec3 eye{x, ground_at(heights, x, z) + kEyeHeight, z};
  SeededRandom random(41);
  add_grove(mesh, heights, eye, {9.0, 140.0, 16, 3000}, random);
  add_grove(mesh, heights, eye, {140.0, 600.0, 24, 500}, random);
  Scene scene;
  mesh.move_into(scene);
  scene.ground_triangles = static_cast<std::size_t>(2) * kCells * kCells;
  scene.camera = camera_looking(eye, eye + glm::dvec3(220.0, -62.0, 400.0));
  scene.camera.far_plane = 12000.0;
  scene.light_direction = sunlight(sun_elevation, 24.0);
  scene.shadow_distance_metres = kShadowDistance;
  scene.seen_distance_metres = kSeenDistance;
  return scene;
}

}  // namespace

Scene valley_5() {
  return valley(5.0);
}

Scene valley_20() {
  return valley(20.0);
}

Scene valley_20_clouds() {
  Scene scene = valley(20.0);
  scene.clouds = CloudLayer{};
  return scene;
}

Scene valley_45() {
  return valley(45.0);
}

}  // namespace penumbra::scene
