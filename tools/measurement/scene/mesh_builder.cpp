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

// Returns two unit vectors that make a right-handed frame (u, v, axis) with a unit axis.
std::array<glm::dvec3, 2> frame_across(const glm::dvec3& axis) {
  const glm::dvec3 helper = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(helper, axis));
  return {u, glm::cross(axis, u)};
}

// Texture coordinates on a flat sheet, in metres: u along the longer of its first two edges. Sheets of one
// plane continue each other; another plane's have another part of the texture.
struct SheetCoordinates {
  explicit SheetCoordinates(const std::array<glm::dvec3, 3>& corner)
      : normal(glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0]))) {
    const glm::dvec3 first = corner[1] - corner[0], second = corner[2] - corner[1];
    u = glm::normalize(glm::length(first) >= glm::length(second) ? first : second);
    v = glm::cross(normal, u);
  }
  glm::dvec2 at(const glm::dvec3& p) const {
    const double plane = 0.618 * glm::dot(p, normal);
    return {glm::dot(p, u) + plane, glm::dot(p, v) + plane};
  }
  glm::dvec3 normal, u, v;
};

glm::dvec3 spoke(const std::array<glm::dvec3, 2>& across, int side, int sides) {
  const double angle = 2.0 * std::numbers::pi * side / sides;
  return std::cos(angle) * across[0] + std::sin(angle) * across[1];
}

// Returns the angle about a tube's axis, there and back again, so that the texture meets itself where the
// round closes.
double girth(int side, int sides) {
  return 2.0 * std::numbers::pi * std::min(side, sides - side) / sides;
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

void MeshBuilder::use(const Material& material, double metres_per_texture) {
  metres_per_texture_ = metres_per_texture;
  const auto same_name = [&](const Material& known) { return known.name == material.name; };
  const auto found = std::find_if(materials_.begin(), materials_.end(), same_name);
  material_ = static_cast<std::uint16_t>(found - materials_.begin());
  if (found == materials_.end()) materials_.push_back(material);
}

int MeshBuilder::add_texture(Texture texture) {
  textures_.push_back(std::move(texture));
  return static_cast<int>(textures_.size()) - 1;
}

void MeshBuilder::move_into(Scene& scene) {
  scene.mesh = std::move(mesh_);
  scene.materials = std::move(materials_);
  scene.textures = std::move(textures_);
}

std::uint32_t MeshBuilder::vertex(const glm::dvec3& position, const glm::dvec3& normal,
                                  const glm::dvec2& uv) {
  mesh_.positions.push_back(rounded(position));
  mesh_.normals.push_back(rounded(normal));
  const glm::vec3 on_texture = rounded({uv / metres_per_texture_, 0.0});
  mesh_.uvs.emplace_back(on_texture.x, on_texture.y);
  return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

void MeshBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  mesh_.triangle_materials.push_back(material_);
}

void MeshBuilder::triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const SheetCoordinates sheet({a, b, c});
  const std::uint32_t first = vertex(a, sheet.normal, sheet.at(a));
  vertex(b, sheet.normal, sheet.at(b));
  vertex(c, sheet.normal, sheet.at(c));
  add_triangle(first, first + 1, first + 2);
}

void MeshBuilder::quad(const std::array<glm::dvec3, 4>& corners) {
  const SheetCoordinates sheet({corners[0], corners[1], corners[2]});
  const std::uint32_t first = vertex(corners[0], sheet.normal, sheet.at(corners[0]));
  for (int i = 1; i < 4; ++i) vertex(corners[i], sheet.normal, sheet.at(corners[i]));
  add_triangle(first, first + 1, first + 2);
  add_triangle(first, first + 2, first + 3);
}

void MeshBuilder::card(const std::array<glm::dvec3, 4>& corners, const glm::dvec2& repeats) {
  const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const glm::dvec2 size = metres_per_texture_ * repeats;
  const std::uint32_t first = vertex(corners[0], normal, {0.0, 0.0});
  vertex(corners[1], normal, {size.x, 0.0});
  vertex(corners[2], normal, size);
  vertex(corners[3], normal, {0.0, size.y});
  add_triangle(first, first + 1, first + 2);
  add_triangle(first, first + 2, first + 3);
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
    vertex(tube.from + tube.radius_from * out, normal, {0.0, tube.radius_from * girth(side, tube.sides)});
    vertex(tube.to + tube.radius_to * out, normal,
           {glm::length(along), tube.radius_from * girth(side, tube.sides)});
  }
  const auto count = static_cast<std::uint32_t>(2 * tube.sides);
  for (std::uint32_t i = 0; i < count; i += 2) {
    const std::uint32_t low = first + i, high = low + 1;
    const std::uint32_t next_low = first + (i + 2) % count, next_high = next_low + 1;
    add_triangle(low, next_low, next_high);
    add_triangle(low, next_high, high);
  }
  cap(tube, across, false);
  cap(tube, across, true);
}

void MeshBuilder::cap(const Tube& tube, const std::array<glm::dvec3, 2>& across, bool at_end) {
  const glm::dvec3 axis = glm::cross(across[0], across[1]);
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (int side = 0; side < tube.sides; ++side) {
    const glm::dvec3 out = spoke(across, side, tube.sides);
    const double radius = at_end ? tube.radius_to : tube.radius_from;
    const glm::dvec2 uv{radius * glm::dot(out, across[0]), radius * glm::dot(out, across[1])};
    vertex((at_end ? tube.to : tube.from) + radius * out, at_end ? axis : -axis, uv);
  }
  for (std::uint32_t i = 2; i < static_cast<std::uint32_t>(tube.sides); ++i) {
    if (at_end) {
      add_triangle(first, first + i - 1, first + i);
    } else {
      add_triangle(first, first + i, first + i - 1);
    }
  }
}

void MeshBuilder::gable(const Gable& gable) {
  const double x = 0.5 * gable.size.x, y = gable.size.y, z = 0.5 * gable.size.z;
  const auto at = [&](double px, double py, double pz) { return gable.base_centre + glm::dvec3(px, py, pz); };
  quad({at(-x, 0, -z), at(x, 0, -z), at(x, 0, z), at(-x, 0, z)});
  quad({at(-x, 0, -z), at(-x, 0, z), at(0, y, z), at(0, y, -z)});
  quad({at(x, 0, z), at(x, 0, -z), at(0, y, -z), at(0, y, z)});
  triangle(at(-x, 0, -z), at(0, y, -z), at(x, 0, -z));
  triangle(at(x, 0, z), at(0, y, z), at(-x, 0, z));
}

void MeshBuilder::heights(const glm::dvec2& corner, double cell, int cells,
                          const std::vector<double>& heights) {
  const int side = cells + 1;
  const auto at = [&](int x, int z) {
    const int column = std::clamp(x, 0, cells), row = std::clamp(z, 0, cells);
    return heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
                   static_cast<std::size_t>(column)];
  };
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (int z = 0; z < side; ++z)
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 place = corner + cell * glm::dvec2(x, z);
      const glm::dvec3 slope{at(x - 1, z) - at(x + 1, z), 2.0 * cell, at(x, z - 1) - at(x, z + 1)};
      vertex({place.x, at(x, z), place.y}, glm::normalize(slope), place);
    }
  const auto index = [&](int x, int z) { return first + static_cast<std::uint32_t>(z * side + x); };
  for (int z = 0; z < cells; ++z)
    for (int x = 0; x < cells; ++x) {
      add_triangle(index(x, z), index(x, z + 1), index(x + 1, z + 1));
      add_triangle(index(x, z), index(x + 1, z + 1), index(x + 1, z));
    }
}

void MeshBuilder::ground(const glm::dvec3& centre, double half_size) {
  const auto at = [&](double x, double z) { return glm::dvec3(centre.x + x, 0.0, centre.z + z); };
  quad({at(-half_size, -half_size), at(-half_size, half_size), at(half_size, half_size),
        at(half_size, -half_size)});
}

}  // namespace penumbra::scene
