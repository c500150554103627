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

// Returns a disc that has no size yet.
DiscLight facing(const glm::dvec3& to_light) {
  DiscLight disc;
  disc.to_light = to_light;
  const glm::dvec3 aside =
      std::abs(disc.to_light.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  disc.right = glm::normalize(glm::cross(aside, disc.to_light));
  disc.up = glm::cross(disc.to_light, disc.right);
  return disc;
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
  DiscLight disc = facing(-light.direction / length);
  disc.sin_half = std::sin(half);
  disc.tan_half = std::tan(half);
  return disc;
}

LightSource::LightSource(const parameters::SpotLight& spot) : spot_(spot) {
  parameters::check_spot_light(spot);
  spot_->direction = glm::normalize(spot.direction);
  cos_outer_ = std::cos(spot.outer_angle_degrees * std::numbers::pi / 360.0);
}

std::optional<DiscLight> LightSource::seen_from(const glm::dvec3& position) const {
  if (!spot_) return disc_;
  const glm::dvec3 to_light = spot_->position - position;
  const double distance = glm::length(to_light);
  const double radius = spot_->source_radius_metres;
  if (!(distance > radius) || distance > spot_->range_metres) return std::nullopt;
  DiscLight disc = facing(to_light / distance);
  if (glm::dot(-disc.to_light, spot_->direction) < cos_outer_) return std::nullopt;
  disc.sin_half = radius / std::hypot(radius, distance);
  disc.tan_half = radius / distance;
  disc.distance = distance;
  return disc;
}

double surface_offset(const glm::vec3& position) {
  const double largest = std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z), 1.0F});
  return std::ldexp(largest, -15);
}

std::optional<LitReceiver> lit_receiver(const scene::Receivers& receivers, std::size_t pixel,
                                        const LightSource& light) {
  const glm::vec4& seen = receivers.position_relative[pixel];
  if (!(receivers.position_ws[pixel].w > 0.5F)) return std::nullopt;
  const glm::dvec3 position(seen);
  const glm::dvec3 normal(receivers.normal_ws[pixel]);
  const double length = glm::length(normal);
  if (!finite(position) || !finite(normal) || !(length > 0.5)) return std::nullopt;
  const glm::dvec3 unit = normal / length;
  const glm::dvec3 lifted = position + unit * surface_offset(glm::vec3(seen));
  const std::optional<DiscLight> disc = light.seen_from(lifted);
  if (!disc || glm::dot(unit, disc->to_light) <= disc->sin_half) return std::nullopt;
  return LitReceiver{lifted, unit};
}

std::vector<std::uint8_t> valid_receivers(const scene::Receivers& receivers, const LightSource& light) {
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
