// Rays per second of the ray-traced reference beside a bare Embree loop on the same scene.
//
// Both trace the same rays, from what the scene's camera sees to the same points of the disc, in the same
// packets on all threads, over a scene built once. The bare loop makes its rays, asks Embree, and ignores the
// answers. Counters:
//   bare_rays     rays per second of the bare loop
//   tracer_rays   of the reference: sampling, counting, rows, progress, cancellation, noise floor
//   whole_rays    of trace_visibility as a user calls it: with the build of the scene and the cache key
//   tracer_to_bare, whole_to_bare      by time that passed
//   tracer_to_bare_cpu                 by processor time: what holds on a machine that does other work too
// The label repeats the ratio in words. Runs alternate, so that a change of the machine's load meets both.
#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "reference/disc_tracer.h"
#include "reference/embree_scene.h"
#include "reference/trace_visibility.h"
#include "scene/scene.h"

namespace penumbra::reference {
namespace {

constexpr int samples = 1024;
constexpr ImageSize picture{480, 270};

RTCRayHit camera_ray(const parameters::Camera& camera, int x, int y) {
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, camera.forward));
  const glm::dvec3 forward = glm::normalize(camera.forward);
  const glm::dvec3 up = glm::cross(forward, right);
  const double half_height = std::tan(camera.fov_y_degrees * std::numbers::pi / 360.0);
  const double across = (2.0 * (x + 0.5) / picture.width - 1.0) * half_height * camera.aspect;
  const double along = (1.0 - 2.0 * (y + 0.5) / picture.height) * half_height;
  const glm::vec3 origin(camera.position);
  const glm::vec3 direction(forward + across * right + along * up);
  RTCRayHit ray{};
  ray.ray = {origin.x,    origin.y,    origin.z,
             0.0F,        direction.x, direction.y,
             direction.z, 0.0F,        std::numeric_limits<float>::infinity(),
             ~0U,         0,           0};
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return ray;
}

scene::Receivers seen_by_camera(const scene::Scene& scene, const EmbreeScene& embree) {
  scene::Receivers receivers;
  receivers.width = picture.width;
  receivers.height = picture.height;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      RTCRayHit ray = camera_ray(scene.camera, x, y);
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      rtcIntersect1(embree.handle(), &context, &ray);
      const bool hit = ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
      const glm::vec3 direction(ray.ray.dir_x, ray.ray.dir_y, ray.ray.dir_z);
      const glm::vec3 place = glm::vec3(scene.camera.position) + (hit ? ray.ray.tfar : 0.0F) * direction;
      glm::vec3 normal =
          hit ? glm::normalize(glm::vec3(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z)) : glm::vec3(0.0F);
      if (glm::dot(normal, direction) > 0.0F) normal = -normal;
      receivers.position_relative.emplace_back(place, hit ? 1.0F : 0.0F);
      receivers.position_ws.emplace_back(place, hit ? 1.0F : 0.0F);
      receivers.normal_ws.emplace_back(normal, 0.0F);
    }
  }
  return receivers;
}

// Traces one frame's worth of rays, and does nothing else.
class BareLoop {
 public:
  BareLoop(const EmbreeScene& embree, const scene::Receivers& receivers, const DiscLight& light)
      : embree_(embree), light_(light), points_(samples, 1) {
    for (std::size_t pixel = 0; pixel < receivers.position_ws.size(); ++pixel) {
      const auto receiver = lit_receiver(receivers, pixel, light);
      if (receiver) starts_.push_back({glm::vec3(receiver->position), points_.draw(pixel)});
    }
  }

  double rays() const { return static_cast<double>(starts_.size()) * samples; }

  void run() const {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, starts_.size(), 32), [&](const auto& pixels) {
      for (std::size_t pixel = pixels.begin(); pixel < pixels.end(); ++pixel) shoot(starts_[pixel]);
    });
  }

 private:
  static constexpr std::size_t lanes = 16;
  struct Start {
    glm::vec3 origin;
    PixelDraw draw;
  };

  void shoot(const Start& start) const {
    alignas(64) RTCRay16 rays{};
    alignas(64) int valid[lanes];
    std::fill(valid, valid + lanes, -1);
    std::fill(rays.org_x, rays.org_x + lanes, start.origin.x);
    std::fill(rays.org_y, rays.org_y + lanes, start.origin.y);
    std::fill(rays.org_z, rays.org_z + lanes, start.origin.z);
    std::fill(rays.mask, rays.mask + lanes, ~0U);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    const double cosine = std::cos(start.draw.angle) * light_.tan_half;
    const double sine = std::sin(start.draw.angle) * light_.tan_half;
    const glm::vec3 centre(light_.to_light);
    const glm::vec3 right(cosine * light_.right + sine * light_.up);
    const glm::vec3 up(cosine * light_.up - sine * light_.right);
    const float* x = points_.x(start.draw.pair);
    const float* y = points_.y(start.draw.pair);
    for (std::size_t point = 0; point < samples; point += lanes) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        rays.dir_x[lane] = centre.x + x[point + lane] * right.x + y[point + lane] * up.x;
        rays.dir_y[lane] = centre.y + x[point + lane] * right.y + y[point + lane] * up.y;
        rays.dir_z[lane] = centre.z + x[point + lane] * right.z + y[point + lane] * up.z;
        rays.tfar[lane] = std::numeric_limits<float>::infinity();
      }
      rtcOccluded16(valid, embree_.handle(), &context, &rays);
      benchmark::DoNotOptimize(rays.tfar[0]);
    }
  }

  const EmbreeScene& embree_;
  DiscLight light_;
  DiscSamples points_;
  std::vector<Start> starts_;
};

struct Spent {
  double seconds = 0.0;
  double processor_seconds = 0.0;  // processor time of all threads

  template <typename Work>
  void add(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t processor_start = std::clock();
    work();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    processor_seconds += static_cast<double>(std::clock() - processor_start) / CLOCKS_PER_SEC;
  }
};

void tracer_to_bare(benchmark::State& state) {
  const std::string name = scene::built_in_names()[static_cast<std::size_t>(state.range(0))];
  const scene::Scene scene = scene::built_in(name);
  const parameters::Light light{scene.light_direction, 0.01 * static_cast<double>(state.range(1))};
  const DiscLight disc = disc_light(light);
  const EmbreeScene embree(scene);
  const scene::Receivers receivers = seen_by_camera(scene, embree);
  const BareLoop bare(embree, receivers, disc);
  const DiscTracer tracer(embree, disc, samples, 1);
  RowJob job;
  job.size = picture;
  job.valid = valid_receivers(receivers, disc);
  job.samples = samples;
  job.rays_per_pixel = samples;
  job.count = [&](std::size_t pixel) {
    return tracer.lit_points(lit_receiver(receivers, pixel, disc).value(), pixel);
  };
  Spent bare_loop;
  Spent traced;
  Spent whole;
  double rays = 0.0;
  for ([[maybe_unused]] auto iteration : state) {
    bare_loop.add([&] { bare.run(); });
    traced.add([&] { benchmark::DoNotOptimize(run_rows(job, {}, nullptr)); });
    whole.add([&] { benchmark::DoNotOptimize(trace_visibility(scene, receivers, light, {samples, 1})); });
    rays += bare.rays();
  }
  const double ratio = bare_loop.seconds / traced.seconds;
  state.counters["bare_rays"] = rays / bare_loop.seconds;
  state.counters["tracer_rays"] = rays / traced.seconds;
  state.counters["whole_rays"] = rays / whole.seconds;
  state.counters["tracer_to_bare"] = ratio;
  state.counters["tracer_to_bare_cpu"] = bare_loop.processor_seconds / traced.processor_seconds;
  state.counters["whole_to_bare"] = bare_loop.seconds / whole.seconds;
  state.SetLabel(name + ": tracer reaches " + std::to_string(static_cast<int>(std::lround(100.0 * ratio))) +
                 " % of a bare Embree loop");
}

void every_scene_and_sun(benchmark::internal::Benchmark* runs) {
  const auto scenes = static_cast<std::int64_t>(scene::built_in_names().size());
  runs->ArgNames({"scene", "degrees_x100"});
  for (std::int64_t scene = 0; scene < scenes; ++scene) {
    for (const std::int64_t hundredths : {53, 500}) runs->Args({scene, hundredths});
  }
}

BENCHMARK(tracer_to_bare)
    ->Apply(every_scene_and_sun)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MinTime(0.5);

}  // namespace
}  // namespace penumbra::reference

BENCHMARK_MAIN();
