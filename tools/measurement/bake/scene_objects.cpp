#include "bake/scene_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <unordered_map>

#include "input/input_error.h"
#include "scene/joined_sets.h"

namespace penumbra::bake {
namespace {

constexpr double kLevel = 1e-3;        // the largest height of ground, as a share of its width
constexpr double kGroundWidth = 0.25;  // the least width of ground, as a share of the scene's

void check(const scene::Scene& scene, int most) {
  if (most < 1 || most > most_field_objects) {
    throw InputError(
        "", fmt::format("a scene has from 1 to {} objects with fields, not {}", most_field_objects, most));
  }
  if (scene.mesh.triangle_count() == 0)
    throw InputError("", "the scene '" + scene.name + "' has no triangles");
  for (const std::uint32_t index : scene.mesh.indices) {
    if (index >= scene.mesh.positions.size()) {
      throw InputError("", fmt::format("the scene '{}' has an index {} and {} vertices", scene.name, index,
                                       scene.mesh.positions.size()));
    }
    const glm::vec3& position = scene.mesh.positions[index];
    if (std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z)) continue;
    throw InputError("",
                     fmt::format("vertex {} of the scene '{}' is not a finite number", index, scene.name));
  }
}

glm::dvec3 corner_of(const scene::Mesh& mesh, std::size_t triangle, std::size_t corner) {
  return glm::dvec3(mesh.positions[mesh.indices[3 * triangle + corner]]);
}

bool has_area(const scene::Mesh& mesh, std::size_t triangle) {
  const glm::dvec3 first = corner_of(mesh, triangle, 0);
  const glm::dvec3 normal =
      glm::cross(corner_of(mesh, triangle, 1) - first, corner_of(mesh, triangle, 2) - first);
  return glm::dot(normal, normal) > 0.0;
}

parameters::Bounds joined(const parameters::Bounds& one, const parameters::Bounds& other) {
  return {glm::min(one.minimum, other.minimum), glm::max(one.maximum, other.maximum)};
}

parameters::Bounds nothing() {
  return {glm::dvec3(std::numeric_limits<double>::infinity()),
          glm::dvec3(-std::numeric_limits<double>::infinity())};
}

struct Part {
  std::vector<std::uint32_t> triangles;
  parameters::Bounds box = nothing();
};

// Positions that differ by no more than rounding count as one, the first of them.
class Welded {
 public:
  explicit Welded(double apart) : apart_(apart) {}

  // Returns the number of the position; positions are numbered in the order in which they come.
  std::uint32_t number(const glm::vec3& position) {
    const glm::dvec3 place(position);
    const glm::ivec3 cell = cell_of(place);
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          const auto found = in_cell_.find(key(cell + glm::ivec3(x, y, z)));
          if (found == in_cell_.end()) continue;
          for (const std::uint32_t other : found->second)
            if (glm::distance(place, glm::dvec3(positions_[other])) <= apart_) return other;
        }
    const auto number = static_cast<std::uint32_t>(positions_.size());
    positions_.push_back(position);
    in_cell_[key(cell)].push_back(number);
    return number;
  }

  const glm::vec3& position(std::uint32_t number) const { return positions_[number]; }
  std::size_t count() const { return positions_.size(); }

 private:
  // Cells are twice the distance wide; a scene has a few million of them along each side.
  glm::ivec3 cell_of(const glm::dvec3& place) const { return glm::ivec3(glm::floor(place / (2.0 * apart_))); }
  static std::uint64_t key(const glm::ivec3& cell) {
    constexpr std::uint64_t kBits = (std::uint64_t{1} << 21U) - 1;
    return (static_cast<std::uint64_t>(cell.x) & kBits) |
           ((static_cast<std::uint64_t>(cell.y) & kBits) << 21U) |
           ((static_cast<std::uint64_t>(cell.z) & kBits) << 42U);
  }

  double apart_;
  std::vector<glm::vec3> positions_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> in_cell_;
};

// Returns the rounding error of positions: two computations of one vertex in single precision differ by up to
// 2^-20 of the largest coordinate.
double rounding(const scene::Mesh& mesh) {
  float largest = 0.0F;
  for (const std::uint32_t index : mesh.indices) {
    const glm::vec3 at = glm::abs(mesh.positions[index]);
    largest = std::max({largest, at.x, at.y, at.z});
  }
  return std::max(static_cast<double>(largest), 1e-30) * 0x1p-20;
}

// Returns the parts in the order of their first triangles.
std::vector<Part> parts_of(const scene::Mesh& mesh, std::size_t& flat) {
  Welded welded(rounding(mesh));
  std::vector<std::uint32_t> places;  // the welded position of each index
  places.reserve(mesh.indices.size());
  for (const std::uint32_t index : mesh.indices) places.push_back(welded.number(mesh.positions[index]));
  scene::JoinedSets joined_places(welded.count());
  for (std::size_t i = 0; i < places.size(); i += 3) {
    joined_places.join(places[i], places[i + 1]);
    joined_places.join(places[i], places[i + 2]);
  }
  std::vector<Part> parts;
  std::unordered_map<std::uint32_t, std::size_t> part_of;
  for (std::size_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
    if (!has_area(mesh, triangle)) {
      ++flat;
      continue;
    }
    const auto found = part_of.try_emplace(joined_places.of(places[3 * triangle]), parts.size());
    if (found.second) parts.emplace_back();
    Part& part = parts[found.first->second];
    part.triangles.push_back(static_cast<std::uint32_t>(triangle));
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 corner = corner_of(mesh, triangle, i);
      part.box = joined(part.box, {corner, corner});
    }
  }
  return parts;
}

bool is_ground(const Part& part, const parameters::Bounds& all) {
  const glm::dvec3 size = part.box.maximum - part.box.minimum, whole = all.maximum - all.minimum;
  return size.y <= kLevel * std::max(size.x, size.z) && size.x >= kGroundWidth * whole.x &&
         size.z >= kGroundWidth * whole.z;
}

// A measure of the voxels that a box costs. A box without height still costs a little more than nothing.
double volume(const parameters::Bounds& box) {
  const glm::dvec3 size = box.maximum - box.minimum;
  const double least = 0.01 * std::max({size.x, size.y, size.z});
  return std::max(size.x, least) * std::max(size.y, least) * std::max(size.z, least);
}

parameters::Bounds box_of(const std::vector<Part>& parts, const std::vector<std::size_t>& some) {
  parameters::Bounds box = nothing();
  for (const std::size_t part : some) box = joined(box, parts[part].box);
  return box;
}

struct Cut {
  double volume = std::numeric_limits<double>::infinity();  // the sum of both boxes
  std::vector<std::size_t> low, high;
};

// Cuts the parts in two, in the order of their middles along one axis, where both boxes are the smallest.
Cut cut(const std::vector<Part>& parts, const std::vector<std::size_t>& some) {
  Cut best;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<std::size_t> order = some;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
      const auto middle = [&](std::size_t i) {
        return parts[i].box.minimum[axis] + parts[i].box.maximum[axis];
      };
      return middle(one) < middle(other);
    });
    std::vector<double> behind(order.size() + 1, 0.0);  // volume of the parts from there on
    parameters::Bounds box = nothing();
    for (std::size_t i = order.size(); i-- > 0;) {
      box = joined(box, parts[order[i]].box);
      behind[i] = volume(box);
    }
    box = nothing();
    for (std::size_t i = 1; i < order.size(); ++i) {
      box = joined(box, parts[order[i - 1]].box);
      const double both = volume(box) + behind[i];
      if (both >= best.volume) continue;
      const auto middle = order.begin() + static_cast<std::ptrdiff_t>(i);
      best = {both, {order.begin(), middle}, {middle, order.end()}};
    }
  }
  return best;
}

std::vector<std::vector<std::size_t>> grouped(const std::vector<Part>& parts,
                                              const std::vector<std::size_t>& casters, std::size_t most) {
  std::vector<std::vector<std::size_t>> groups{casters};
  while (groups.size() < most) {
    const auto size = [&](const std::vector<std::size_t>& group) {
      return group.size() < 2 ? -1.0 : volume(box_of(parts, group));
    };
    const auto largest =
        std::max_element(groups.begin(), groups.end(),
                         [&](const auto& one, const auto& other) { return size(one) < size(other); });
    if (largest->size() < 2) break;
    Cut two = cut(parts, *largest);
    *largest = std::move(two.low);
    groups.push_back(std::move(two.high));
  }
  return groups;
}

}  // namespace

SceneObjects objects_of(const scene::Scene& scene, int most) {
  check(scene, most);
  SceneObjects found;
  const std::vector<Part> parts = parts_of(scene.mesh, found.flat_triangles);
  parameters::Bounds all = nothing();
  for (const Part& part : parts) all = joined(all, part.box);
  std::vector<std::size_t> casters;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (is_ground(parts[i], all)) {
      found.ground_triangles += parts[i].triangles.size();
    } else {
      casters.push_back(i);
    }
  }
  if (parts.empty()) throw InputError("", "no triangle of the scene '" + scene.name + "' has an area");
  if (casters.empty())
    throw InputError("", "the scene '" + scene.name + "' is level ground alone, without an object on it");
  found.parts = casters.size();
  for (const std::vector<std::size_t>& group : grouped(parts, casters, static_cast<std::size_t>(most))) {
    SceneObject object;
    object.parts = group.size();
    object.box = box_of(parts, group);
    for (const std::size_t part : group) {
      object.triangles.insert(object.triangles.end(), parts[part].triangles.begin(),
                              parts[part].triangles.end());
    }
    std::sort(object.triangles.begin(), object.triangles.end());
    found.objects.push_back(std::move(object));
  }
  std::stable_sort(found.objects.begin(), found.objects.end(),
                   [](const auto& one, const auto& other) { return volume(one.box) > volume(other.box); });
  return found;
}

scene::Scene scene_of(const scene::Scene& scene, const SceneObject& object) {
  scene::Scene own;
  own.name = scene.name;
  own.origin = scene.origin;
  Welded welded(rounding(scene.mesh));
  for (const std::uint32_t triangle : object.triangles) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3& position = scene.mesh.positions[scene.mesh.indices[3 * std::size_t{triangle} + i]];
      corners[i] = welded.number(position);
    }
    own.mesh.indices.insert(own.mesh.indices.end(), corners.begin(), corners.end());
  }
  for (std::size_t i = 0; i < welded.count(); ++i)
    own.mesh.positions.push_back(welded.position(static_cast<std::uint32_t>(i)));
  own.mesh.normals.assign(own.mesh.positions.size(), glm::vec3(0.0F, 1.0F, 0.0F));
  return own;
}

}  // namespace penumbra::bake
