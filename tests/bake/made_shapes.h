// Closed meshes of simple shapes about the origin, in metres.
#pragma once

#include <cmath>
#include <functional>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace penumbra::bake {

inline scene::Scene mesh_of(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices) {
  scene::Scene scene;
  scene.name = "mesh";
  scene.mesh.normals.assign(positions.size(), glm::vec3(0.0F, 1.0F, 0.0F));
  scene.mesh.positions = std::move(positions);
  scene.mesh.indices = std::move(indices);
  return scene;
}

inline scene::Scene box(const glm::vec3& half) {
  std::vector<glm::vec3> positions;
  for (int i = 0; i < 8; ++i)
    positions.emplace_back((i & 1) != 0 ? half.x : -half.x, (i & 2) != 0 ? half.y : -half.y,
                           (i & 4) != 0 ? half.z : -half.z);
  return mesh_of(std::move(positions), {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                        2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5});
}

// A grid over [0, 1)^2 that closes on itself, or ends in two poles where `around` is not closed along v.
inline scene::Scene surface(int across, int along, bool torus,
                            const std::function<glm::dvec3(double, double)>& at) {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  const int rows = torus ? along : along + 1;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < across; ++i)
      positions.emplace_back(glm::vec3(at(static_cast<double>(i) / across, static_cast<double>(j) / along)));
  const auto index = [&](int i, int j) {
    return static_cast<std::uint32_t>((torus ? j % along : j) * across + i % across);
  };
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < across; ++i) {
      const std::uint32_t a = index(i, j), b = index(i + 1, j), c = index(i, j + 1), d = index(i + 1, j + 1);
      if (torus || j > 0) indices.insert(indices.end(), {a, b, c});
      if (torus || j + 1 < along) indices.insert(indices.end(), {b, d, c});
    }
  return mesh_of(std::move(positions), std::move(indices));
}

inline constexpr double kHalfTurn = 3.14159265358979323846;

inline scene::Scene sphere(double radius, int across, int along) {
  return surface(across, along, false, [=](double u, double v) {
    const double ring = v == 0.0 || v == 1.0 ? 0.0 : std::sin(kHalfTurn * v);
    return radius * glm::dvec3(ring * std::cos(2.0 * kHalfTurn * u), std::cos(kHalfTurn * v),
                               ring * std::sin(2.0 * kHalfTurn * u));
  });
}

inline scene::Scene torus(double ring, double tube, int across, int along) {
  return surface(across, along, true, [=](double u, double v) {
    const double out = ring + tube * std::cos(2.0 * kHalfTurn * v);
    return glm::dvec3(out * std::cos(2.0 * kHalfTurn * u), tube * std::sin(2.0 * kHalfTurn * v),
                      out * std::sin(2.0 * kHalfTurn * u));
  });
}

}  // namespace penumbra::bake
