#include "scene/scene.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "input/input_error.h"

namespace penumbra::scene {
namespace {

// Directions are derived through sin, cos and square roots, whose last bits differ between machines; 2^-40
// keeps them unit to 10^-12 and the same everywhere.
glm::dvec3 rounded_direction(const glm::dvec3& direction) {
  constexpr double grid = 1099511627776.0;  // 2^40
  return glm::round(direction * grid) / grid + 0.0;
}

}  // namespace

parameters::Bounds Scene::bounds() const {
  if (mesh.positions.empty()) return {glm::dvec3(0.0), glm::dvec3(0.0)};
  glm::vec3 minimum(std::numeric_limits<float>::infinity());
  glm::vec3 maximum(-std::numeric_limits<float>::infinity());
  for (const glm::vec3& position : mesh.positions) {
    minimum = glm::min(minimum, position);
    maximum = glm::max(maximum, position);
  }
  return {glm::dvec3(minimum), glm::dvec3(maximum)};
}

glm::dvec3 sunlight(double elevation_degrees, double azimuth_degrees) {
  if (!(elevation_degrees > 0.0 && elevation_degrees <= 90.0) || !std::isfinite(azimuth_degrees)) {
    throw InputError("", "the sun's elevation must be above 0 and at most 90 degrees, its azimuth finite",
                     "a sun below the horizon casts no shadow");
  }
  const double elevation = glm::radians(elevation_degrees);
  const double azimuth = glm::radians(azimuth_degrees);
  return rounded_direction(-glm::dvec3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                                       std::cos(elevation) * std::cos(azimuth)));
}

glm::dvec3 sun_before(const glm::dvec3& light_direction, double degrees) {
  if (degrees == 0.0) return light_direction;
  const glm::dvec3 light = glm::normalize(light_direction);
  // The sun moves from east (+X) by south (-Z) to west; east, up and north are left-handed axes.
  const glm::dvec3 polar_axis = glm::normalize(glm::dvec3(0.0, 1.0, 1.0));
  const glm::dvec3 along_arc = glm::cross(polar_axis, light);
  // At the pole, where the sun never is, any direction will do.
  const glm::dvec3 onward =
      glm::length(along_arc) > 1e-6 ? glm::normalize(along_arc) : glm::dvec3(1.0, 0.0, 0.0);
  const double angle = glm::radians(degrees);
  return std::cos(angle) * light - std::sin(angle) * onward;
}

parameters::Camera camera_looking(const glm::dvec3& position, const glm::dvec3& target) {
  parameters::Camera camera;
  camera.position = position;
  camera.forward = rounded_direction(glm::normalize(target - position));
  return camera;
}

}  // namespace penumbra::scene
