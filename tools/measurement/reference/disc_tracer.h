// The inner loop of the ray-traced reference: how many points of the light's disc one receiver sees.
//
// Rays go in packets of 16 with Embree's coherent flag: packets of neighbouring directions from one point are
// the fastest of its occlusion queries. Reentrant.
#pragma once

#include <cstddef>
#include <cstdint>

#include "reference/disc_samples.h"
#include "reference/embree_scene.h"
#include "reference/lit_receiver.h"
#include "reference/visibility_image.h"

namespace penumbra::reference {

class DiscTracer {
 public:
  static constexpr int packet_size = 16;

  // `samples` has the meaning of TraceOptions::samples. The scene must outlive the tracer.
  DiscTracer(const EmbreeScene& scene, const DiscLight& light, int samples, std::uint64_t seed);

  // The halves are the two sets of the pair that the pixel's draw names. One ray to a point light decides
  // both, unless blended triangles let some of its rays pass.
  HalfCounts lit_points(const LitReceiver& receiver, std::size_t pixel) const;

  int rays_per_pixel() const { return light_.tan_half == 0.0 && !scene_.any_blended() ? 1 : samples_; }

 private:
  HalfCounts lit_by_point_light(const LitReceiver& receiver) const;

  const EmbreeScene& scene_;
  DiscLight light_;
  int samples_;
  DiscSamples points_;
};

}  // namespace penumbra::reference
