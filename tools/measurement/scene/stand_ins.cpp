#include "scene/stand_ins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>

#include "scene/joined_sets.h"

namespace penumbra::scene {
namespace {

constexpr double kSameHeight = 1e-3;
constexpr double kLevel = 0.99999;  // cosine of a quarter of a degree

struct Triangle {
  std::array<glm::dvec3, 3> corners;
  glm::dvec3 area;  // twice its area, along its outward side
};

Triangle triangle_of(const Mesh& mesh, std::size_t triangle) {
  const auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[3 * triangle + k]]); };
  const std::array<glm::dvec3, 3> corners{at(0), at(1), at(2)};
  return {corners, glm::cross(corners[1] - corners[0], corners[2] - corners[0])};
}

void join_equal_positions(const Mesh& mesh, JoinedSets& sets) {
  std::vector<std::uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto place = [&](std::uint32_t i) {
    const glm::vec3& at = mesh.positions[i];
    return std::tuple(at.x, at.y, at.z);
  };
  const auto before = [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); };
  std::sort(order.begin(), order.end(), before);
  for (std::size_t i = 1; i < order.size(); ++i)
    if (place(order[i]) == place(order[i - 1])) sets.join(order[i], order[i - 1]);
}

struct Part {
  double surface = 0.0;
  glm::dvec3 moment{0.0};  // moment of the surface
  glm::dvec3 minimum{std::numeric_limits<double>::infinity()};
  glm::dvec3 maximum{-std::numeric_limits<double>::infinity()};

  void add(const Triangle& triangle) {
    const double area = 0.5 * glm::length(triangle.area);
    surface += area;
    for (const glm::dvec3& corner : triangle.corners) {
      moment += corner * (area / 3.0);
      minimum = glm::min(minimum, corner);
      maximum = glm::max(maximum, corner);
    }
  }
  bool is_shorter_than(const glm::dvec3& size) const {
    const glm::dvec3 own = maximum - minimum;
    return own.x < size.x && own.z < size.z;
  }
};

}  // namespace

double ground_level(const Mesh& mesh) {
  std::map<long, std::pair<double, double>> levels;  // area, and area times height
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const Triangle triangle = triangle_of(mesh, i);
    for (const glm::dvec3& corner : triangle.corners) lowest = std::min(lowest, corner.y);
    const double area = glm::length(triangle.area);
    if (!(triangle.area.y > kLevel * area)) continue;
    const double height = (triangle.corners[0].y + triangle.corners[1].y + triangle.corners[2].y) / 3.0;
    auto& level = levels[std::lround(height / kSameHeight)];
    level.first += area;
    level.second += area * height;
  }
  const auto most = std::max_element(levels.begin(), levels.end(), [](const auto& a, const auto& b) {
    return a.second.first < b.second.first;
  });
  if (most != levels.end()) return most->second.second / most->second.first;
  return std::isfinite(lowest) ? lowest : 0.0;
}

std::vector<Ball> object_balls(const Mesh& mesh, std::size_t most) {
  const double ground = ground_level(mesh);
  JoinedSets sets(mesh.positions.size());
  std::vector<std::size_t> standing;
  Part all;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const Triangle triangle = triangle_of(mesh, i);
    all.add(triangle);
    const bool in_ground =
        std::all_of(triangle.corners.begin(), triangle.corners.end(),
                    [&](const auto& corner) { return std::abs(corner.y - ground) < kSameHeight; });
    if (in_ground) continue;
    standing.push_back(i);
    for (const std::size_t k : {1U, 2U}) sets.join(mesh.indices[3 * i], mesh.indices[3 * i + k]);
  }
  join_equal_positions(mesh, sets);
  std::map<std::uint32_t, Part> parts;
  for (const std::size_t i : standing) parts[sets.of(mesh.indices[3 * i])].add(triangle_of(mesh, i));
  std::vector<Ball> balls;
  for (const auto& [root, part] : parts)
    if (part.surface > 0.0 && part.is_shorter_than(0.5 * (all.maximum - all.minimum)))
      balls.push_back({part.moment / part.surface, std::sqrt(part.surface / (4.0 * std::numbers::pi))});
  std::stable_sort(balls.begin(), balls.end(),
                   [](const Ball& a, const Ball& b) { return a.radius > b.radius; });
  if (balls.size() > most) balls.resize(most);
  return balls;
}

}  // namespace penumbra::scene
