#include "scene/shadow_volume.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

#include "input/input_error.h"
#include "scene/joined_sets.h"

namespace penumbra::scene {
namespace {

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

using Corners = std::array<std::uint32_t, 3>;

struct PositionHash {
  std::size_t operator()(const glm::vec3& position) const {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis)
      hash = (hash ^ std::bit_cast<std::uint32_t>(position[axis])) * 0x9E37'79B9'7F4A'7C15U;
    return static_cast<std::size_t>(hash ^ (hash >> 32U));
  }
};

bool has_finite_axes(const glm::dvec3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

// Triangles between vertices of different positions.
struct WeldedMesh {
  std::vector<glm::vec3> positions;
  std::vector<Corners> triangles;

  WeldedMesh(const std::vector<glm::vec3>& from, const std::vector<std::uint32_t>& indices) {
    if (indices.size() % 3 != 0)
      throw InputError(
          "", "a shadow volume of " + std::to_string(indices.size()) + " indices: triangles have three each");
    std::vector<std::uint32_t> welded(from.size(), kNoVertex);
    for (std::size_t first = 0; first < indices.size(); first += 3) {
      Corners corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = weld(from, indices[first + k], welded);
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
        triangles.push_back(corners);
    }
  }

 private:
  std::uint32_t weld(const std::vector<glm::vec3>& from, std::uint32_t index,
                     std::vector<std::uint32_t>& welded) {
    if (index >= from.size())
      throw InputError("", "a shadow volume with the index " + std::to_string(index) + " of " +
                               std::to_string(from.size()) + " vertices");
    std::uint32_t& vertex = welded[index];
    if (vertex != kNoVertex) return vertex;
    if (!has_finite_axes(glm::dvec3(from[index])))
      throw InputError("", "vertex " + std::to_string(index) + " of a shadow volume is not finite");
    const auto [found, is_new] =
        at_.try_emplace(from[index] + glm::vec3(0.0F), static_cast<std::uint32_t>(positions.size()));
    if (is_new) positions.push_back(found->first);
    return vertex = found->second;
  }

  std::unordered_map<glm::vec3, std::uint32_t, PositionHash> at_;
};

// An edge of a triangle, by the smaller vertex first.
struct Side {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t triangle = 0;
  int sign = 0;  // 1 if the triangle passes it from low to high, else -1

  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> sorted_sides(const std::vector<Corners>& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles[triangle][k], to = triangles[triangle][(k + 1) % 3];
      sides.push_back(
          {std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(triangle), from < to ? 1 : -1});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high) || (a.same_edge(b) && a.triangle < b.triangle);
  });
  return sides;
}

// Calls visit(first, last) for the sides of each edge.
template <typename Visit>
void for_each_edge(const std::vector<Side>& sides, Visit visit) {
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].same_edge(sides[begin])) ++end;
    visit(&sides[begin], sides.data() + end);
  }
}

int sum_of_signs(const Side* first, const Side* last) {
  return std::accumulate(first, last, 0, [](int sum, const Side& side) { return sum + side.sign; });
}

// The pieces of a mesh are triangles that are joined by edges.
class Pieces {
 public:
  explicit Pieces(const std::vector<Corners>& triangles) : sets_(triangles.size()) {
    const std::vector<Side> sides = sorted_sides(triangles);
    for_each_edge(sides, [this](const Side* first, const Side* last) {
      for (const Side* side = first + 1; side != last; ++side) sets_.join(side->triangle, first->triangle);
    });
    is_open_.assign(triangles.size(), false);
    for_each_edge(sides, [this](const Side* first, const Side* last) {
      if (sum_of_signs(first, last) != 0) is_open_[sets_.of(first->triangle)] = true;
    });
  }

  bool is_open(std::uint32_t triangle) { return is_open_[sets_.of(triangle)]; }

  void count(ShadowVolume& volume) {
    for (std::uint32_t triangle = 0; triangle < is_open_.size(); ++triangle)
      if (sets_.of(triangle) == triangle) ++(is_open_[triangle] ? volume.open_pieces : volume.closed_pieces);
  }

 private:
  JoinedSets sets_;
  std::vector<bool> is_open_;  // indexed by a piece's first triangle
};

// The casting triangles, wound so that their normals point towards the light.
std::vector<Corners> cap_towards(const WeldedMesh& mesh, const glm::dvec3& way, ShadowVolume& volume) {
  Pieces pieces(mesh.triangles);
  pieces.count(volume);
  std::vector<Corners> cap;
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const Corners& corners = mesh.triangles[triangle];
    const glm::dvec3 a(mesh.positions[corners[0]]);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(mesh.positions[corners[1]]) - a, glm::dvec3(mesh.positions[corners[2]]) - a);
    const double along = glm::dot(normal, way);
    if (along > 0.0)
      cap.push_back({corners[0], corners[2], corners[1]});
    else if (along < 0.0 && pieces.is_open(static_cast<std::uint32_t>(triangle)))
      cap.push_back(corners);
  }
  return cap;
}

// Vertices that the cap does not use are left out.
void keep_used(std::vector<Corners>& cap, std::vector<glm::vec3>& positions) {
  std::vector<std::uint32_t> kept(positions.size(), kNoVertex);
  std::vector<glm::vec3> used;
  for (Corners& corners : cap)
    for (std::uint32_t& corner : corners) {
      if (kept[corner] == kNoVertex) {
        kept[corner] = static_cast<std::uint32_t>(used.size());
        used.push_back(positions[corner]);
      }
      corner = kept[corner];
    }
  positions = std::move(used);
}

void add_moved(std::vector<glm::vec3>& positions, const glm::dvec3& way) {
  const std::size_t count = positions.size();
  positions.reserve(2 * count);
  for (std::size_t vertex = 0; vertex < count; ++vertex) {
    const glm::vec3 moved(glm::dvec3(positions[vertex]) + way);
    if (!has_finite_axes(glm::dvec3(moved)))
      throw InputError("", "a shadow volume that reaches beyond the range of a float",
                       "give it a smaller length");
    positions.push_back(moved);
  }
}

}  // namespace

ShadowVolume shadow_volume(const std::vector<glm::vec3>& positions,
                           const std::vector<std::uint32_t>& triangles, const glm::dvec3& way) {
  if (!has_finite_axes(way) || way == glm::dvec3(0.0))
    throw InputError("", "a shadow volume without a direction and a length",
                     "give it a way along the light that leaves the scene's bounds");
  WeldedMesh mesh(positions, triangles);
  ShadowVolume volume;
  std::vector<Corners> cap = cap_towards(mesh, way, volume);
  volume.positions = std::move(mesh.positions);
  keep_used(cap, volume.positions);
  volume.caps = cap.size();
  const auto moved = static_cast<std::uint32_t>(volume.positions.size());
  add_moved(volume.positions, way);
  const auto add = [&volume](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    volume.indices.insert(volume.indices.end(), {a, b, c});
  };
  for (const Corners& at : cap) add(at[0], at[1], at[2]);
  for (const Corners& at : cap) add(moved + at[0], moved + at[2], moved + at[1]);
  for_each_edge(sorted_sides(cap), [&](const Side* first, const Side* last) {
    const int sum = sum_of_signs(first, last);
    const std::uint32_t from = sum > 0 ? first->low : first->high, to = sum > 0 ? first->high : first->low;
    for (int wall = 0; wall < std::abs(sum); ++wall, ++volume.walls) {
      add(to, from, moved + from);
      add(to, moved + from, moved + to);
    }
  });
  return volume;
}

ShadowVolume shadow_volume(const Scene& scene) {
  std::vector<std::uint32_t> triangles;
  for (std::size_t triangle = 0; triangle < scene.mesh.triangle_count(); ++triangle) {
    const std::optional<CutOut>& cut_out = scene.materials.at(scene.mesh.material_of(triangle)).cut_out;
    if (cut_out && cut_out->mode == AlphaMode::blended) continue;
    for (std::size_t k = 0; k < 3; ++k) triangles.push_back(scene.mesh.indices[3 * triangle + k]);
  }
  const parameters::Bounds bounds = scene.bounds();
  const glm::dvec3 direction = glm::normalize(scene.light_direction);
  const double extent = glm::dot(glm::abs(direction), bounds.maximum - bounds.minimum);
  constexpr double kBeyond = 1.01;
  constexpr double kLeastMetres = 0.01;
  return shadow_volume(scene.mesh.positions, triangles, (kBeyond * extent + kLeastMetres) * direction);
}

}  // namespace penumbra::scene
