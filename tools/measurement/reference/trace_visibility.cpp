#include "reference/trace_visibility.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "input/input_error.h"
#include "platform/hashed_fields.h"
#include "reference/disc_samples.h"
#include "reference/disc_tracer.h"
#include "reference/embree_scene.h"
#include "reference/lit_receiver.h"
#include "scene/cut_out.h"

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

constexpr int tracing_version = 1;  // increased whenever a change affects any result

std::string key_of(const scene::Scene& scene, const scene::Receivers& receivers,
                   const parameters::Light& light, const TraceOptions& options) {
  return platform::hash_of("T1", tracing_version, scene.mesh.positions, scene.mesh.indices,
                           scene::CutOuts(scene), receivers.width, receivers.height,
                           receivers.position_relative, receivers.position_ws, receivers.normal_ws,
                           platform::hash_of(light), options);
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
  job.samples = options.samples;
  if (std::optional<VisibilityImage> kept = kept_image(job, cache)) return *std::move(kept);
  const EmbreeScene embree(scene);
  const DiscTracer tracer(embree, disc, options.samples, options.seed);
  job.rays_per_pixel = tracer.rays_per_pixel();
  job.count = [&](std::size_t pixel) {
    return tracer.lit_points(lit_receiver(receivers, pixel, disc).value(), pixel);
  };
  return run_rows(job, run, cache);
}

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
