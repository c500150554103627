#include "scene/scene.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "input/input_error.h"

namespace penumbra::scene {
namespace {

std::uint32_t mixed(std::uint32_t bits) {
  bits = (bits ^ (bits >> 15U)) * 0x2C1B3C6DU;
  bits = (bits ^ (bits >> 12U)) * 0x297A2D39U;
  return bits ^ (bits >> 15U);
}

double corner_value(std::int64_t x, std::int64_t z, std::uint32_t octave) {
  const std::uint32_t bits = mixed(static_cast<std::uint32_t>(x) * 0x8DA6B343U ^
                                   static_cast<std::uint32_t>(z) * 0xD8163841U ^ octave * 0xCB1AB31FU);
  return (bits >> 8U) / 16777215.0;
}

// Returns the weights of a cell's lower and upper corner along one axis.
std::array<double, 2> faded(double t) {
  const double upper = std::pow(t, 3) * (10.0 - 15.0 * t + 6.0 * t * t);
  return {1.0 - upper, upper};
}

double octave_of_noise(const glm::dvec2& place, std::uint32_t octave) {
  const auto x = static_cast<std::int64_t>(std::floor(place.x));
  const auto z = static_cast<std::int64_t>(std::floor(place.y));
  const std::array<double, 2> across = faded(place.x - static_cast<double>(x));
  const std::array<double, 2> along = faded(place.y - static_cast<double>(z));
  double sum = 0.0;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      sum += across[i] * along[j] *
             corner_value(x + static_cast<std::int64_t>(i), z + static_cast<std::int64_t>(j), octave);
  return sum;
}

// Directions are derived through sin, cos and square roots, whose last bits differ between machines; 2^-40
// keeps them unit to 10^-12 and the same everywhere.
glm::dvec3 rounded_direction(const glm::dvec3& direction) {
  constexpr double grid = 1099511627776.0;  // 2^40
  return glm::round(direction * grid) / grid + 0.0;
}

}  // namespace

double cloud_transmittance(const CloudLayer& layer, const glm::dvec2& place) {
  if (!(layer.coverage > 0.0)) return 1.0;
  double noise = 0.0;
  for (std::uint32_t octave = 0; octave < 5; ++octave) {
    const double size = layer.feature_metres / static_cast<double>(1U << octave);
    noise += 16.0 / 31.0 / static_cast<double>(1U << octave) * octave_of_noise(place / size, octave + 1);
  }
  const double above = noise - (1.0 - layer.coverage);
  return above <= 0.0 ? 1.0 : std::exp(-layer.density * above / layer.coverage);
}

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
