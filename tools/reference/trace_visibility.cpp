#include "reference/trace_visibility.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "input/input_error.h"
#include "platform/content_hash.h"
#include "reference/disc_tracer.h"
#include "reference/embree_scene.h"
#include "reference/lit_receiver.h"
#include "scene/cut_out.h"

namespace penumbra::reference {
namespace {

constexpr int tracing_version = 1;  // a change of any result takes the next number

std::string key_of(const scene::Scene& scene, const scene::Receivers& receivers,
                   const parameters::Light& light, const TraceOptions& options) {
  platform::ContentHash hash;
  hash.update(std::string_view("T1")).update(tracing_version);
  hash.update(std::span<const glm::vec3>(scene.mesh.positions));
  hash.update(std::span<const std::uint32_t>(scene.mesh.indices));
  scene::CutOuts(scene).add_to(hash);
  hash.update(receivers.width).update(receivers.height);
  hash.update(std::span<const glm::vec4>(receivers.position_relative));
  hash.update(std::span<const glm::vec4>(receivers.position_ws));
  hash.update(std::span<const glm::vec4>(receivers.normal_ws));
  hash.update(light.direction.x).update(light.direction.y).update(light.direction.z);
  hash.update(light.angular_diameter_degrees).update(options.samples).update(options.seed);
  return hash.hex();
}

}  // namespace

void check_samples(int samples) {
  static_assert(fewest_samples == 2 * DiscTracer::packet_size);
  if (samples < fewest_samples || samples > most_samples || (samples & (samples - 1)) != 0) {
    throw InputError("",
                     "samples per pixel must be a power of two from " + std::to_string(fewest_samples) +
                         " to " + std::to_string(most_samples) + ", not " + std::to_string(samples),
                     "1024 is the default");
  }
}

VisibilityImage trace_visibility(const scene::Scene& scene, const scene::Receivers& receivers,
                                 const parameters::Light& light, const TraceOptions& options,
                                 const RunOptions& run, const ReferenceCache* cache) {
  check_samples(options.samples);
  const DiscLight disc = disc_light(light);
  RowJob job;
  job.size = {receivers.width, receivers.height};
  job.valid = valid_receivers(receivers, disc);
  job.key = key_of(scene, receivers, light, options);
  if (cache != nullptr) {
    if (std::optional<VisibilityImage> known = cache->find(job.key)) return *std::move(known);
  }
  const EmbreeScene embree(scene);
  const DiscTracer tracer(embree, disc, options.samples, options.seed);
  job.samples = options.samples;
  job.rays_per_pixel = tracer.rays_per_pixel();
  job.count = [&](std::size_t pixel) {
    return tracer.lit_points(lit_receiver(receivers, pixel, disc).value(), pixel);
  };
  return run_rows(job, run, cache);
}

}  // namespace penumbra::reference
