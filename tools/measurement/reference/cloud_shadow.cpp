#include "reference/cloud_shadow.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "reference/disc_samples.h"
#include "reference/lit_receiver.h"

namespace penumbra::reference {
namespace {

constexpr std::uint32_t kPoints = 64;

std::vector<glm::dvec3> directions_to(const DiscLight& light) {
  std::vector<glm::dvec3> directions;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const glm::dvec2 point = concentric_disc(scrambled_sobol(i, 0)) * light.tan_half;
    directions.push_back(glm::normalize(light.to_light + point.x * light.right + point.y * light.up));
  }
  return directions;
}

double passing(const scene::CloudLayer& layer, const glm::dvec3& from,
               const std::vector<glm::dvec3>& directions) {
  const double rise = layer.altitude_metres - from.y;
  if (rise < 0.0) return 1.0;
  double sum = 0.0;
  for (const glm::dvec3& direction : directions) {
    if (direction.y <= 0.0) continue;
    const glm::dvec3 at = from + direction * (rise / direction.y);
    sum += std::pow(scene::cloud_transmittance(layer, {at.x, at.z}), 1.0 / direction.y);
  }
  return sum / static_cast<double>(directions.size());
}

}  // namespace

void shade_by_clouds(VisibilityImage& image, const scene::Scene& scene, const scene::Receivers& receivers,
                     const parameters::Light& light) {
  if (!scene.clouds) return;
  const std::vector<glm::dvec3> directions = directions_to(disc_light(light));
  for (std::size_t pixel = 0; pixel < image.visibility.size(); ++pixel) {
    if (image.valid[pixel] == 0) continue;
    const glm::dvec3 from = scene.origin + glm::dvec3(receivers.position_relative[pixel]);
    const double clouds = std::clamp(passing(*scene.clouds, from, directions), 0.0, 1.0);
    image.visibility[pixel] = static_cast<float>(image.visibility[pixel] * clouds);
  }
}

}  // namespace penumbra::reference
