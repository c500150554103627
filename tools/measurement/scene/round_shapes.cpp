// MeshBuilder's shapes with rounded surfaces, and leaves.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "scene/mesh_builder.h"

namespace penumbra::scene {
namespace {

constexpr double kCosOfCrease = 0.642787609686539;  // 50 degrees

using Profile = std::vector<std::array<double, 2>>;

// Returns the normal of a lathe's profile from point i to i + 1: (out, up) on its right, unit.
glm::dvec2 segment_normal(const Profile& profile, std::size_t i) {
  const glm::dvec2 way(profile[i + 1][0] - profile[i][0], profile[i + 1][1] - profile[i][1]);
  return glm::normalize(glm::dvec2(way.y, -way.x));
}

// Returns the normal at one end of segment i, smoothed with the neighbour there unless the profile has a
// crease.
glm::dvec2 end_normal(const Profile& profile, std::size_t i, bool at_start) {
  const glm::dvec2 own = segment_normal(profile, i);
  const bool has_neighbour = at_start ? i > 0 : i + 2 < profile.size();
  if (!has_neighbour) return own;
  const glm::dvec2 other = segment_normal(profile, at_start ? i - 1 : i + 1);
  return glm::dot(own, other) > kCosOfCrease ? glm::normalize(own + other) : own;
}

// Returns the corners' shifts, interpolated trilinearly over the box's half sizes.
glm::dvec3 shift_at(const RoundedBox& box, const glm::dvec3& p) {
  glm::dvec3 sum(0.0);
  const glm::dvec3 share = 0.5 + p / box.size;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) weight *= corner >> axis & 1 ? share[axis] : 1.0 - share[axis];
    sum += weight * box.corner_shift[corner];
  }
  return sum;
}

// The normal of the shifted surface: normals transform by the cofactors of the shift's Jacobian.
glm::dvec3 shifted_normal(const RoundedBox& box, const glm::dvec3& p, const glm::dvec3& normal) {
  constexpr double step = 1.0 / 1024.0;
  glm::dmat3 jacobian(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 way(0.0);
    way[axis] = step;
    jacobian[axis] += (shift_at(box, p + way) - shift_at(box, p - way)) / (2.0 * step);
  }
  return glm::normalize(glm::transpose(glm::inverse(jacobian)) * normal);
}

}  // namespace

// Points of a circle, or one point where the radius is 0.
struct MeshBuilder::Ring {
  std::uint32_t first;
  bool is_point;
  std::uint32_t at(int side, int sides) const {
    return is_point ? first : first + static_cast<std::uint32_t>(side % sides);
  }
};

void MeshBuilder::join(const Ring& low, const Ring& high, int sides) {
  for (int side = 0; side < sides; ++side) {
    const std::uint32_t a = low.at(side, sides), b = low.at(side + 1, sides);
    const std::uint32_t c = high.at(side + 1, sides), d = high.at(side, sides);
    if (!low.is_point) add_triangle(a, b, c);
    if (!high.is_point) add_triangle(a, c, d);
  }
}

void MeshBuilder::lathe(const Lathe& lathe) {
  const auto ring = [&](std::size_t point, const glm::dvec2& normal, double way) {
    const auto [radius, height] = lathe.profile[point];
    const Ring made{static_cast<std::uint32_t>(mesh_.positions.size()), radius == 0.0};
    for (int side = 0; side < (made.is_point ? 1 : lathe.sides); ++side) {
      const double angle = 2.0 * std::numbers::pi * side / lathe.sides;
      // The angle runs from +Z towards +X: with Y up, that is the direction of the rings of a lateral
      // surface.
      const glm::dvec3 out{std::sin(angle), 0.0, std::cos(angle)};
      const glm::dvec3 turned = lathe.pose.rotation * (normal.x * out + glm::dvec3(0.0, normal.y, 0.0));
      const double girth = 2.0 * std::numbers::pi * std::min(side, lathe.sides - side) / lathe.sides;
      vertex(lathe.pose.centre + lathe.pose.rotation * (radius * out + glm::dvec3(0.0, height, 0.0)),
             made.is_point ? lathe.pose.rotation * glm::dvec3(0.0, normal.y > 0.0 ? 1.0 : -1.0, 0.0) : turned,
             {radius * girth, way});
    }
    return made;
  };
  double way = 0.0;
  for (std::size_t i = 0; i + 1 < lathe.profile.size(); ++i) {
    const Ring low = ring(i, end_normal(lathe.profile, i, true), way);
    way += std::hypot(lathe.profile[i + 1][0] - lathe.profile[i][0],
                      lathe.profile[i + 1][1] - lathe.profile[i][1]);
    join(low, ring(i + 1, end_normal(lathe.profile, i, false), way), lathe.sides);
  }
}

void MeshBuilder::bar(const Bar& bar) {
  const std::size_t last = bar.path.size() - 1;
  const auto tangent = [&](std::size_t i) {
    return glm::normalize(bar.path[std::min(i + 1, last)] - bar.path[i == 0 ? 0 : i - 1]);
  };
  const glm::dvec3 start = tangent(0);
  glm::dvec3 u =
      glm::normalize(glm::cross(std::abs(start.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), start));
  double way = 0.0;
  Ring before{};
  for (std::size_t i = 0; i <= last; ++i) {
    const glm::dvec3 axis = tangent(i);
    u = glm::normalize(u - glm::dot(u, axis) * axis);  // the frame turns no more than the line itself
    const glm::dvec3 v = glm::cross(axis, u);
    // 0: the lateral surface; else an end's cap that faces along the axis.
    const auto ring = [&](double facing) {
      const Ring made{static_cast<std::uint32_t>(mesh_.positions.size()), false};
      for (int side = 0; side < bar.sides; ++side) {
        const double angle = 2.0 * std::numbers::pi * side / bar.sides;
        const glm::dvec3 out = std::cos(angle) * u + std::sin(angle) * v;
        vertex(bar.path[i] + bar.radius * out, facing == 0.0 ? out : facing * axis,
               {way, bar.radius * std::min(angle, 2.0 * std::numbers::pi - angle)});
      }
      return made;
    };
    if (i == 0 || i == last) {
      const std::uint32_t first = ring(i == 0 ? -1.0 : 1.0).first;
      for (std::uint32_t k = 2; k < static_cast<std::uint32_t>(bar.sides); ++k) {
        add_triangle(first, first + (i == 0 ? k : k - 1), first + (i == 0 ? k - 1 : k));
      }
    }
    const Ring here = ring(0.0);
    if (i > 0) join(before, here, bar.sides);
    before = here;
    if (i < last) way += glm::distance(bar.path[i], bar.path[i + 1]);
  }
}

void MeshBuilder::rounded_face(const RoundedBox& box, int axis, double sign) {
  const glm::dvec3 half = 0.5 * box.size, inner = half - box.radius;
  const int along_u = (axis + 1) % 3, along_v = (axis + 2) % 3;
  const auto line = [&](int along, int i) {  // the four lines of the face's grid
    const double places[] = {-half[along], -inner[along], inner[along], half[along]};
    return places[i];
  };
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      glm::dvec3 q;
      q[axis] = sign * half[axis];
      q[along_u] = sign * line(along_u, i);
      q[along_v] = line(along_v, j);
      const glm::dvec3 core = glm::clamp(q, -inner, inner);
      const glm::dvec3 out = glm::normalize(q - core);
      const glm::dvec3 place = core + box.radius * out;
      const bool u_is_longer = box.size[along_u] >= box.size[along_v];
      const glm::dvec2 uv(q[u_is_longer ? along_u : along_v], q[u_is_longer ? along_v : along_u]);
      const glm::dvec3& centre = box.pose.centre;
      vertex(centre + box.pose.rotation * (place + shift_at(box, place)),
             box.pose.rotation * shifted_normal(box, place, out),
             uv + 0.618 * glm::dvec2(centre.x + centre.z, centre.y + centre.z));
    }
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) {
      const std::uint32_t a = first + 4 * i + j, b = a + 4, c = b + 1, d = a + 1;
      add_triangle(a, b, c);
      add_triangle(a, c, d);
    }
  }
}

void MeshBuilder::rounded_box(const RoundedBox& box) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) rounded_face(box, axis, sign);
  }
}

void MeshBuilder::leaf(const Leaf& leaf) {
  const glm::dvec3 up = glm::cross(leaf.along, leaf.across);
  const double fold = glm::radians(leaf.fold_degrees);
  const glm::dvec3 tip = leaf.stalk + leaf.length * leaf.along;
  const glm::dvec3 rib = leaf.stalk + 0.5 * leaf.length * leaf.along;
  const glm::dvec3 waist = leaf.stalk + 0.4 * leaf.length * leaf.along;
  const glm::dvec3 out = 0.5 * leaf.width * std::cos(fold) * leaf.across;
  const glm::dvec3 raised = waist + 0.5 * leaf.width * std::sin(fold) * up;
  triangle(leaf.stalk, rib, raised + out);
  triangle(raised + out, rib, tip);
  triangle(leaf.stalk, raised - out, rib);
  triangle(raised - out, tip, rib);
}

}  // namespace penumbra::scene
