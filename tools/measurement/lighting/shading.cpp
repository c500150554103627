#include "lighting/shading.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace penumbra::lighting {
namespace {

constexpr float kMirrored = 0.04F;  // reflectance at normal incidence for an index of refraction of 1.5
constexpr float kPi = std::numbers::pi_v<float>;

float schlick(float cosine) {
  return kMirrored + (1.0F - kMirrored) * std::pow(1.0F - std::clamp(cosine, 0.0F, 1.0F), 5.0F);
}

// alpha is roughness squared. It is kept from 0, where the highlight would be a point without an area.
float ggx(const SurfacePoint& point, const glm::vec3& to_camera, const glm::vec3& to_sun, float n_l) {
  const float n_v = std::max(glm::dot(point.normal, to_camera), 1e-3F);
  const glm::vec3 half = glm::normalize(to_camera + to_sun);
  const float n_h = std::clamp(glm::dot(point.normal, half), 0.0F, 1.0F);
  const float alpha = std::max(point.roughness * point.roughness, 0.01F);
  const float a2 = alpha * alpha;
  const float d = n_h * n_h * (a2 - 1.0F) + 1.0F;
  const float distribution = a2 / (kPi * d * d);
  const float smith =
      n_l * std::sqrt(n_v * n_v * (1.0F - a2) + a2) + n_v * std::sqrt(n_l * n_l * (1.0F - a2) + a2);
  return distribution * schlick(glm::dot(half, to_sun)) * 0.5F / smith;
}

// Returns 1 where triangle and interpolated normal agree, and 0 where the sun sets behind the triangle.
float terminator(const SurfacePoint& point, const glm::vec3& to_sun, float n_l) {
  const float flat_l = glm::dot(point.flat_normal, to_sun);
  const float both = n_l * std::max(glm::dot(point.flat_normal, point.normal), 1e-3F);
  const float g = std::clamp(flat_l / both, 0.0F, 1.0F);
  return g * (1.0F + g - g * g);
}

}  // namespace

glm::vec3 lit_by_sun(const SurfacePoint& point, const glm::vec3& to_camera, const Sunlight& sun) {
  const float n_l = glm::dot(point.normal, sun.to_sun);
  if (!(n_l > 0.0F) || !(glm::dot(point.flat_normal, sun.to_sun) > 0.0F)) return glm::vec3(0.0F);
  const glm::vec3 matt = point.base_colour * ((1.0F - point.translucency) * (1.0F - schlick(n_l)) / kPi);
  const glm::vec3 reflected = matt + ggx(point, to_camera, sun.to_sun, n_l);
  return reflected * sun.irradiance * (n_l * terminator(point, sun.to_sun, n_l));
}

glm::vec3 lit_through(const SurfacePoint& point, const Sunlight& sun) {
  const float flat_l = glm::dot(point.flat_normal, sun.to_sun);
  if (!(flat_l < 0.0F)) return glm::vec3(0.0F);
  return point.base_colour * sun.irradiance * (point.translucency * -flat_l / kPi);
}

glm::vec3 lit_by_sky(const SurfacePoint& point, const glm::vec3& to_camera, const glm::vec3& sky_light) {
  const float n_v = std::clamp(glm::dot(point.normal, to_camera), 0.0F, 1.0F);
  const float smooth = 1.0F - point.roughness;
  const float gloss =
      std::min(smooth * smooth, std::exp2(-9.28F * n_v)) * smooth + 0.0425F - 0.0275F * point.roughness;
  return sky_light * (point.base_colour * (1.0F - gloss) + gloss);
}

}  // namespace penumbra::lighting
