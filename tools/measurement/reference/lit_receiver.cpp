#include "reference/lit_receiver.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "input/input_error.h"

namespace penumbra::reference {
namespace {

bool finite(const glm::dvec3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

}  // namespace

DiscLight disc_light(const parameters::Light& light) {
  const double length = glm::length(light.direction);
  if (!finite(light.direction) || !(length > 0.0) || !std::isfinite(length)) {
    throw InputError("", "the light's direction is zero or not finite",
                     "give the direction in which the light travels");
  }
  const double diameter = light.angular_diameter_degrees;
  if (!(diameter >= 0.0 && diameter <= 30.0)) {
    throw InputError("", "the light's angular diameter is outside 0 to 30 degrees", "the sun's is 0.53");
  }
  const double half = diameter * std::numbers::pi / 360.0;
  DiscLight disc;
  disc.to_light = -light.direction / length;
  const glm::dvec3 aside =
      std::abs(disc.to_light.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  disc.right = glm::normalize(glm::cross(aside, disc.to_light));
  disc.up = glm::cross(disc.to_light, disc.right);
  disc.sin_half = std::sin(half);
  disc.tan_half = std::tan(half);
  return disc;
}

double surface_offset(const glm::vec3& position) {
  const double largest = std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z), 1.0F});
  return std::ldexp(largest, -15);
}

std::optional<LitReceiver> lit_receiver(const scene::Receivers& receivers, std::size_t pixel,
                                        const DiscLight& light) {
  const glm::vec4& seen = receivers.position_relative[pixel];
  if (!(receivers.position_ws[pixel].w > 0.5F)) return std::nullopt;
  const glm::dvec3 position(seen);
  const glm::dvec3 normal(receivers.normal_ws[pixel]);
  const double length = glm::length(normal);
  if (!finite(position) || !finite(normal) || !(length > 0.5)) return std::nullopt;
  const glm::dvec3 unit = normal / length;
  const glm::dvec3 lifted = position + unit * surface_offset(glm::vec3(seen));
  if (glm::dot(unit, light.to_light) <= light.sin_half) return std::nullopt;
  return LitReceiver{lifted, unit};
}

std::vector<std::uint8_t> valid_receivers(const scene::Receivers& receivers, const DiscLight& light) {
  const std::size_t pixels =
      static_cast<std::size_t>(receivers.width) * static_cast<std::size_t>(receivers.height);
  if (receivers.width <= 0 || receivers.height <= 0 || receivers.position_relative.size() != pixels ||
      receivers.position_ws.size() != pixels || receivers.normal_ws.size() != pixels) {
    throw InputError("", "the receiver buffers do not hold width x height pixels");
  }
  std::vector<std::uint8_t> valid(pixels);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    valid[pixel] = lit_receiver(receivers, pixel, light) ? 1 : 0;
  }
  return valid;
}

}  // namespace penumbra::reference
