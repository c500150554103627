#include "scene/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace penumbra::scene {
namespace {

glm::vec3 rounded(const glm::dvec3& v) {
  constexpr double grid = 1 << 20;
  const auto round_one = [](double x) {
    return static_cast<float>(std::round(x * grid) / grid + 0.0);  // + 0.0 turns -0 into 0
  };
  return {round_one(v.x), round_one(v.y), round_one(v.z)};
}

// Two unit vectors that make a right-handed frame (u, v, axis) with a unit axis.
std::array<glm::dvec3, 2> frame_across(const glm::dvec3& axis) {
  const glm::dvec3 helper = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(helper, axis));
  return {u, glm::cross(axis, u)};
}

glm::dvec3 spoke(const std::array<glm::dvec3, 2>& across, int side, int sides) {
  const double angle = 2.0 * std::numbers::pi * side / sides;
  return std::cos(angle) * across[0] + std::sin(angle) * across[1];
}

}  // namespace

glm::dmat3 rotation(double yaw_degrees, double pitch_degrees, double roll_degrees) {
  const auto turn = [](double degrees, int from, int to) {
    const double angle = glm::radians(degrees);
    glm::dmat3 matrix(1.0);
    matrix[from][from] = matrix[to][to] = std::cos(angle);
    matrix[from][to] = std::sin(angle);
    matrix[to][from] = -std::sin(angle);
    return matrix;
  };
  return turn(yaw_degrees, 2, 0) * turn(pitch_degrees, 1, 2) * turn(roll_degrees, 0, 1);
}

void MeshBuilder::use(const Material& material) {
  const auto same_name = [&](const Material& known) { return known.name == material.name; };
  const auto found = std::find_if(materials_.begin(), materials_.end(), same_name);
  material_ = static_cast<std::uint16_t>(found - materials_.begin());
  if (found == materials_.end()) materials_.push_back(material);
}

void MeshBuilder::move_into(Scene& scene) {
  scene.mesh = std::move(mesh_);
  scene.materials = std::move(materials_);
}

std::uint32_t MeshBuilder::vertex(const glm::dvec3& position, const glm::dvec3& normal) {
  mesh_.positions.push_back(rounded(position));
  mesh_.normals.push_back(rounded(normal));
  return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

void MeshBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  mesh_.triangle_materials.push_back(material_);
}

void MeshBuilder::flat_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
  const std::uint32_t first = vertex(a, normal);
  vertex(b, normal);
  vertex(c, normal);
  triangle(first, first + 1, first + 2);
}

void MeshBuilder::quad(const std::array<glm::dvec3, 4>& corners) {
  const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const std::uint32_t first = vertex(corners[0], normal);
  for (int i = 1; i < 4; ++i) vertex(corners[i], normal);
  triangle(first, first + 1, first + 2);
  triangle(first, first + 2, first + 3);
}

void MeshBuilder::box(const Pose& pose, const glm::dvec3& size) {
  // Each of the six faces is spanned by the two axes that follow its normal cyclically: n = u x v.
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      glm::dvec3 n(0.0), u(0.0), v(0.0);
      n[axis] = sign * 0.5 * size[axis];
      u[(axis + 1) % 3] = sign * 0.5 * size[(axis + 1) % 3];
      v[(axis + 2) % 3] = 0.5 * size[(axis + 2) % 3];
      const auto corner = [&](double s, double t) {
        return pose.centre + pose.rotation * (n + s * u + t * v);
      };
      quad({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
    }
  }
}

void MeshBuilder::standing_box(const glm::dvec3& base_centre, const glm::dvec3& size, double yaw_degrees) {
  box({base_centre + glm::dvec3(0, 0.5 * size.y, 0), rotation(yaw_degrees)}, size);
}

void MeshBuilder::tube(const Tube& tube) {
  const glm::dvec3 along = tube.to - tube.from;
  const glm::dvec3 axis = glm::normalize(along);
  const std::array<glm::dvec3, 2> across = frame_across(axis);
  // The mantle's normal leans towards the thinner end by the slope of the radius.
  const double lean = (tube.radius_from - tube.radius_to) / glm::length(along);
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (int side = 0; side < tube.sides; ++side) {
    const glm::dvec3 out = spoke(across, side, tube.sides);
    const glm::dvec3 normal = glm::normalize(out + lean * axis);
    vertex(tube.from + tube.radius_from * out, normal);
    vertex(tube.to + tube.radius_to * out, normal);
  }
  const auto count = static_cast<std::uint32_t>(2 * tube.sides);
  for (std::uint32_t i = 0; i < count; i += 2) {
    const std::uint32_t low = first + i, high = low + 1;
    const std::uint32_t next_low = first + (i + 2) % count, next_high = next_low + 1;
    triangle(low, next_low, next_high);
    triangle(low, next_high, high);
  }
  cap(tube, across, false);
  cap(tube, across, true);
}

void MeshBuilder::cap(const Tube& tube, const std::array<glm::dvec3, 2>& across, bool at_end) {
  const glm::dvec3 axis = glm::cross(across[0], across[1]);
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (int side = 0; side < tube.sides; ++side) {
    const glm::dvec3 out = spoke(across, side, tube.sides);
    if (at_end) {
      vertex(tube.to + tube.radius_to * out, axis);
    } else {
      vertex(tube.from + tube.radius_from * out, -axis);
    }
  }
  for (std::uint32_t i = 2; i < static_cast<std::uint32_t>(tube.sides); ++i) {
    if (at_end) {
      triangle(first, first + i - 1, first + i);
    } else {
      triangle(first, first + i, first + i - 1);
    }
  }
}

void MeshBuilder::gable(const Gable& gable) {
  const double x = 0.5 * gable.size.x, y = gable.size.y, z = 0.5 * gable.size.z;
  const auto at = [&](double px, double py, double pz) { return gable.base_centre + glm::dvec3(px, py, pz); };
  quad({at(-x, 0, -z), at(x, 0, -z), at(x, 0, z), at(-x, 0, z)});
  quad({at(-x, 0, -z), at(-x, 0, z), at(0, y, z), at(0, y, -z)});
  quad({at(x, 0, z), at(x, 0, -z), at(0, y, -z), at(0, y, z)});
  flat_triangle(at(-x, 0, -z), at(0, y, -z), at(x, 0, -z));
  flat_triangle(at(x, 0, z), at(0, y, z), at(-x, 0, z));
}

void MeshBuilder::ground(const glm::dvec3& centre, double half_size) {
  const auto at = [&](double x, double z) { return glm::dvec3(centre.x + x, 0.0, centre.z + z); };
  quad({at(-half_size, -half_size), at(-half_size, half_size), at(half_size, half_size),
        at(half_size, -half_size)});
}

}  // namespace penumbra::scene
