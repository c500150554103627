#include "reference/highest_surface.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <limits>

namespace penumbra::reference {

namespace {

// The ray points straight down.
std::optional<double> height_below(const EmbreeScene& rays, double above, glm::vec2 xz) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray{};
  ray.ray.org_x = xz.x;
  ray.ray.org_y = static_cast<float>(above);
  ray.ray.org_z = xz.y;
  ray.ray.dir_y = -1.0F;
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = ~0U;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(rays.handle(), &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return static_cast<double>(ray.ray.org_y) - static_cast<double>(ray.ray.tfar);
}

}  // namespace

HighestSurface::HighestSurface(const EmbreeScene& rays, const scene::Scene& scene) : rays_(rays) {
  if (scene.mesh.positions.empty()) return;
  const parameters::Bounds bounds = scene.bounds();
  above_ = bounds.maximum.y + 1.0;
  middle_ = {0.5 * (bounds.minimum.x + bounds.maximum.x), 0.5 * (bounds.minimum.z + bounds.maximum.z)};
}

std::optional<double> HighestSurface::at(glm::dvec2 xz) const {
  const glm::vec2 place(xz);
  if (const std::optional<double> height = height_below(rays_, above_, place)) return height;
  // Embree's ray misses a box if it runs in the side of largest x or z, and so misses the scene's own edges.
  return height_below(rays_, above_,
                      {std::nextafter(place.x, middle_.x), std::nextafter(place.y, middle_.y)});
}

}  // namespace penumbra::reference
