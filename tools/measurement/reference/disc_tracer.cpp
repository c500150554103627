#include "reference/disc_tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <iterator>
#include <limits>
#include <numeric>

namespace penumbra::reference {
namespace {

// The disc's two axes, scaled to its radius and turned.
struct TurnedDisc {
  TurnedDisc(const DiscLight& light, double angle) {
    const double cosine = std::cos(angle) * light.tan_half;
    const double sine = std::sin(angle) * light.tan_half;
    centre = glm::vec3(light.to_light);
    right = glm::vec3(cosine * light.right + sine * light.up);
    up = glm::vec3(cosine * light.up - sine * light.right);
  }

  glm::vec3 centre;
  glm::vec3 right;
  glm::vec3 up;
};

// Sixteen rays from one origin. The fields that Embree does not change are written once.
class Packet {
 public:
  explicit Packet(const glm::vec3& origin) {
    std::fill(valid_, valid_ + DiscTracer::packet_size, -1);
    for (int lane = 0; lane < DiscTracer::packet_size; ++lane) {
      rays_.org_x[lane] = origin.x;
      rays_.org_y[lane] = origin.y;
      rays_.org_z[lane] = origin.z;
      rays_.tnear[lane] = 0.0F;
      rays_.time[lane] = 0.0F;
      rays_.mask[lane] = ~0U;
      rays_.id[lane] = 0;
      rays_.flags[lane] = 0;
    }
    rtcInitIntersectContext(&context_);
    context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  }

  // Traces rays towards these points and adds those that meet nothing.
  void shoot(RTCScene scene, const TurnedDisc& disc, const float* x, const float* y) {
    for (int lane = 0; lane < DiscTracer::packet_size; ++lane) {
      rays_.dir_x[lane] = disc.centre.x + x[lane] * disc.right.x + y[lane] * disc.up.x;
      rays_.dir_y[lane] = disc.centre.y + x[lane] * disc.right.y + y[lane] * disc.up.y;
      rays_.dir_z[lane] = disc.centre.z + x[lane] * disc.right.z + y[lane] * disc.up.z;
      rays_.tfar[lane] = std::numeric_limits<float>::infinity();
    }
    rtcOccluded16(valid_, scene, &context_, &rays_);
    for (int lane = 0; lane < DiscTracer::packet_size; ++lane) {
      lit_[lane] += rays_.tfar[lane] >= 0.0F ? 1 : 0;  // Embree sets -infinity where occluded
    }
  }

  HalfCounts lit() const {
    const auto middle = std::begin(lit_) + DiscSamples::half_packet;
    return {static_cast<std::uint16_t>(std::accumulate(std::begin(lit_), middle, 0)),
            static_cast<std::uint16_t>(std::accumulate(middle, std::end(lit_), 0))};
  }

 private:
  alignas(64) RTCRay16 rays_;
  alignas(64) int valid_[DiscTracer::packet_size];
  alignas(64) int lit_[DiscTracer::packet_size] = {};
  RTCIntersectContext context_;
};

}  // namespace

DiscTracer::DiscTracer(const EmbreeScene& scene, const DiscLight& light, int samples, std::uint64_t seed)
    : scene_(scene), light_(light), samples_(samples), points_(static_cast<std::size_t>(samples), seed) {}

HalfCounts DiscTracer::lit_points(const LitReceiver& receiver, std::size_t pixel) const {
  if (light_.tan_half == 0.0) return lit_by_point_light(receiver);
  const PixelDraw draw = points_.draw(pixel);
  const TurnedDisc disc(light_, draw.angle);
  const float* x = points_.x(draw.pair);
  const float* y = points_.y(draw.pair);
  Packet packet{glm::vec3(receiver.position)};
  for (std::size_t point = 0; point < points_.points_per_pair(); point += packet_size) {
    packet.shoot(scene_.handle(), disc, x + point, y + point);
  }
  return packet.lit();
}

HalfCounts DiscTracer::lit_by_point_light(const LitReceiver& receiver) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  const glm::vec3 origin(receiver.position);
  const glm::vec3 direction(light_.to_light);
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.mask = ~0U;
  const int rays = rays_per_pixel();
  int lit[2] = {};  // visible points of each half
  for (int i = 0; i < rays; ++i) {
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.id = static_cast<unsigned>(i);
    rtcOccluded1(scene_.handle(), &context, &ray);
    lit[2 * i / rays] += ray.tfar >= 0.0F ? 1 : 0;
  }
  if (rays == 1) lit[0] = lit[1] = lit[0] * (samples_ / 2);
  return {static_cast<std::uint16_t>(lit[0]), static_cast<std::uint16_t>(lit[1])};
}

}  // namespace penumbra::reference
