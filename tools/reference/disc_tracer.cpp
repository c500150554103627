#include "reference/disc_tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>

namespace penumbra::reference {
namespace {

constexpr float unbounded = std::numeric_limits<float>::infinity();

// The disc's two axes, scaled to its radius and turned by an angle drawn from 32 random bits.
struct TurnedDisc {
  TurnedDisc(const DiscLight& light, std::uint32_t random) {
    const double angle = std::ldexp(random, -32) * 2.0 * std::numbers::pi;
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

// Sixteen rays from one origin; what Embree does not change is written once.
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

  // Rays of this packet that meet nothing.
  int lit(RTCScene scene, const TurnedDisc& disc, const float* x, const float* y) {
    for (int lane = 0; lane < DiscTracer::packet_size; ++lane) {
      rays_.dir_x[lane] = disc.centre.x + x[lane] * disc.right.x + y[lane] * disc.up.x;
      rays_.dir_y[lane] = disc.centre.y + x[lane] * disc.right.y + y[lane] * disc.up.y;
      rays_.dir_z[lane] = disc.centre.z + x[lane] * disc.right.z + y[lane] * disc.up.z;
      rays_.tfar[lane] = unbounded;
    }
    rtcOccluded16(valid_, scene, &context_, &rays_);
    int count = 0;
    for (const float end : rays_.tfar) count += end >= 0.0F ? 1 : 0;  // Embree sets -infinity where occluded
    return count;
  }

 private:
  alignas(64) RTCRay16 rays_;
  alignas(64) int valid_[DiscTracer::packet_size];
  RTCIntersectContext context_;
};

}  // namespace

DiscTracer::DiscTracer(const EmbreeScene& scene, const DiscLight& light, int samples, std::uint64_t seed)
    : scene_(scene),
      light_(light),
      samples_(samples),
      seed_(mixed_bits(seed)),
      points_(static_cast<std::size_t>(samples) / 2, seed) {}

HalfCounts DiscTracer::lit_points(const LitReceiver& receiver, std::size_t pixel) const {
  if (light_.tan_half == 0.0) return lit_by_point_light(receiver);
  const std::uint64_t choice = mixed_bits(seed_ ^ pixel);
  const std::uint64_t turns = mixed_bits(choice);
  const std::size_t first_set = choice % DiscSamples::set_count;
  const std::size_t step = 1 + (choice >> 32) % (DiscSamples::set_count - 1);
  const std::size_t sets[2] = {first_set, (first_set + step) % DiscSamples::set_count};
  const std::uint32_t angles[2] = {static_cast<std::uint32_t>(turns),
                                   static_cast<std::uint32_t>(turns >> 32)};

  Packet packet{glm::vec3(receiver.position)};
  int lit[2] = {0, 0};
  for (int half = 0; half < 2; ++half) {
    const TurnedDisc disc(light_, angles[half]);
    const float* x = points_.x(sets[half]).data();
    const float* y = points_.y(sets[half]).data();
    for (std::size_t point = 0; point < points_.points_per_set(); point += packet_size) {
      lit[half] += packet.lit(scene_.handle(), disc, x + point, y + point);
    }
  }
  return {static_cast<std::uint16_t>(lit[0]), static_cast<std::uint16_t>(lit[1])};
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
  ray.tfar = unbounded;
  ray.mask = ~0U;
  rtcOccluded1(scene_.handle(), &context, &ray);
  const auto half = static_cast<std::uint16_t>(ray.tfar >= 0.0F ? samples_ / 2 : 0);
  return {half, half};
}

}  // namespace penumbra::reference
