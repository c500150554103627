// Properties that the tests of this room ask of a mesh.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "scene/scene.h"

namespace penumbra::scene {

inline std::array<glm::dvec3, 3> corners(const Mesh& mesh, std::size_t triangle) {
  const auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[3 * triangle + k]]); };
  return {at(0), at(1), at(2)};
}

// Twice the area, along the outward side of the winding.
inline glm::dvec3 area_vector(const Mesh& mesh, std::size_t triangle) {
  const auto [a, b, c] = corners(mesh, triangle);
  return glm::cross(b - a, c - a);
}

// Returns the number of edges at which the mesh is not closed and oriented: every edge, found by the places
// of its ends, must be walked as often in one direction as in the other.
inline std::size_t open_edges(const Mesh& mesh) {
  using Place = std::tuple<double, double, double>;
  std::map<std::pair<Place, Place>, int> balance;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const std::array<glm::dvec3, 3> corner = corners(mesh, i);
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 &p = corner[k], &q = corner[(k + 1) % 3];
      const Place from(p.x, p.y, p.z), to(q.x, q.y, q.z);
      balance[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  return static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

// The volume by the divergence theorem: positive when the winding points out of the solid.
inline double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    sum += glm::dot(corners(mesh, i)[0], area_vector(mesh, i)) / 6.0;
  }
  return sum;
}

// The number of times that the mesh winds around a point: about 1 inside a solid, 0 outside, and up to a half
// either way beside an open sheet (van Oosterom and Strackee 1983, solid angle of a triangle).
inline double winding_number(const Mesh& mesh, const glm::dvec3& point) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    auto [a, b, c] = corners(mesh, i);
    a -= point;
    b -= point;
    c -= point;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double above = glm::dot(a, glm::cross(b, c));
    const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    sum += 2.0 * std::atan2(above, below);
  }
  return sum / (4.0 * std::numbers::pi);
}

// Distance along a ray to the nearest triangle, infinite without one (Moeller and Trumbore 1997).
inline double first_hit(const Mesh& mesh, const glm::dvec3& origin, const glm::dvec3& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const auto [a, b, c] = corners(mesh, i);
    const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, p);
    if (std::abs(determinant) < 1e-14) continue;
    const glm::dvec3 from = origin - a, q = glm::cross(from, ab);
    const double u = glm::dot(from, p) / determinant, v = glm::dot(direction, q) / determinant;
    const double t = glm::dot(ac, q) / determinant;
    if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0) nearest = std::min(nearest, t);
  }
  return nearest;
}

}  // namespace penumbra::scene
