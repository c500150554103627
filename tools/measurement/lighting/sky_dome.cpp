#include "lighting/sky_dome.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

namespace penumbra::lighting {
namespace {

constexpr int kSide = 256;

// The octahedron |x| + |y| + |z| = 1 is unfolded onto [-1, 1]^2, with the upper half in the middle.
glm::dvec3 direction_of(double u, double v) {
  glm::dvec3 direction(u, 1.0 - std::abs(u) - std::abs(v), v);
  if (direction.y < 0.0) {
    direction.x = (1.0 - std::abs(v)) * (u < 0.0 ? -1.0 : 1.0);
    direction.z = (1.0 - std::abs(u)) * (v < 0.0 ? -1.0 : 1.0);
  }
  return glm::normalize(direction);
}

// The place is in texels; the table's corners are at -0.5 and kSide - 0.5.
glm::vec2 place_of(const glm::vec3& direction) {
  const float sum = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
  glm::vec2 place(direction.x / sum, direction.z / sum);
  if (direction.y < 0.0F) {
    place = glm::vec2((1.0F - std::abs(direction.z / sum)) * (direction.x < 0.0F ? -1.0F : 1.0F),
                      (1.0F - std::abs(direction.x / sum)) * (direction.z < 0.0F ? -1.0F : 1.0F));
  }
  return (place * 0.5F + 0.5F) * float(kSide) - 0.5F;
}

// Returns the real spherical harmonics of order 0 to 2.
std::array<double, 9> harmonics_at(const glm::dvec3& n) {
  return {0.282095,
          0.488603 * n.y,
          0.488603 * n.z,
          0.488603 * n.x,
          1.092548 * n.x * n.y,
          1.092548 * n.y * n.z,
          0.315392 * (3.0 * n.z * n.z - 1.0),
          1.092548 * n.x * n.z,
          0.546274 * (n.x * n.x - n.y * n.y)};
}

// The factors by which a cosine lobe scales each order.
constexpr std::array<double, 9> kCosineLobe{std::numbers::pi,
                                            2.0 * std::numbers::pi / 3.0,
                                            2.0 * std::numbers::pi / 3.0,
                                            2.0 * std::numbers::pi / 3.0,
                                            std::numbers::pi / 4.0,
                                            std::numbers::pi / 4.0,
                                            std::numbers::pi / 4.0,
                                            std::numbers::pi / 4.0,
                                            std::numbers::pi / 4.0};

}  // namespace

SkyDome::SkyDome(const std::function<glm::dvec3(const glm::dvec3&)>& radiance) {
  table_.reserve(std::size_t{kSide} * kSide);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      table_.emplace_back(
          radiance(direction_of((column + 0.5) / kSide * 2.0 - 1.0, (row + 0.5) / kSide * 2.0 - 1.0)));
    }
  }
  // The points of a Fibonacci sphere each stand for the same solid angle.
  constexpr int kPoints = 8192;
  for (int i = 0; i < kPoints; ++i) {
    const double y = 1.0 - (2.0 * i + 1.0) / kPoints;
    const double angle = 2.0 * std::numbers::pi * i / std::numbers::phi;
    const double sine = std::sqrt(1.0 - y * y);
    const glm::dvec3 direction(sine * std::cos(angle), y, sine * std::sin(angle));
    const glm::dvec3 light = radiance(direction);
    const std::array<double, 9> basis = harmonics_at(direction);
    for (std::size_t k = 0; k < basis.size(); ++k) {
      harmonics_[k] += light * (basis[k] * kCosineLobe[k] * 4.0 * std::numbers::pi / kPoints);
    }
  }
}

glm::vec3 SkyDome::radiance(const glm::vec3& direction) const {
  const glm::vec2 place = glm::clamp(place_of(direction), 0.0F, kSide - 1.0F);
  const int column = std::min(static_cast<int>(place.x), kSide - 2);
  const int row = std::min(static_cast<int>(place.y), kSide - 2);
  const float right = place.x - float(column);
  const float down = place.y - float(row);
  const glm::vec3* texel = table_.data() + row * kSide + column;
  return glm::mix(glm::mix(texel[0], texel[1], right), glm::mix(texel[kSide], texel[kSide + 1], right), down);
}

glm::vec3 SkyDome::irradiance(const glm::vec3& normal) const {
  const std::array<double, 9> basis = harmonics_at(glm::dvec3(normal));
  glm::dvec3 sum(0.0);
  for (std::size_t k = 0; k < basis.size(); ++k) sum += harmonics_[k] * basis[k];
  return glm::max(glm::vec3(sum), glm::vec3(0.0F));
}

}  // namespace penumbra::lighting
