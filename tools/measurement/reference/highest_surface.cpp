#include "reference/highest_surface.h"

#include <embree3/rtcore.h>

#include <limits>

namespace penumbra::reference {

HighestSurface::HighestSurface(const EmbreeScene& rays, const scene::Scene& scene)
    : rays_(rays), above_(scene.mesh.positions.empty() ? 0.0 : scene.bounds().maximum.y + 1.0) {}

std::optional<double> HighestSurface::at(glm::dvec2 xz) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(xz.x);
  ray.ray.org_y = static_cast<float>(above_);
  ray.ray.org_z = static_cast<float>(xz.y);
  ray.ray.dir_y = -1.0F;
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = ~0U;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(rays_.handle(), &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return static_cast<double>(ray.ray.org_y) - static_cast<double>(ray.ray.tfar);
}

}  // namespace penumbra::reference
