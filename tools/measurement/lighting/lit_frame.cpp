#include "lighting/lit_frame.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>
#include <string>

#include "input/input_error.h"
#include "lighting/daylight.h"
#include "lighting/seen_materials.h"
#include "lighting/shading.h"
#include "lighting/sky_dome.h"
#include "lighting/sky_light.h"
#include "lighting/tone_curve.h"
#include "reference/trace_visibility.h"

namespace penumbra::lighting {
namespace {

constexpr int kSmoothingPasses = 2;
constexpr double kWhiteInTheSun = 1.4;  // exposed light of a white matt surface that faces the sun alone

void check(const scene::FrameSettings& frame, int supersampling) {
  const bool divides =
      supersampling > 0 && frame.width % supersampling == 0 && frame.height % supersampling == 0;
  if (divides) return;
  throw InputError("", "a frame of " + std::to_string(frame.width) + "x" + std::to_string(frame.height) +
                           " pixels is not a picture of " + std::to_string(supersampling) + "x" +
                           std::to_string(supersampling) + " samples per pixel");
}

reference::RunOptions run_options(const LitSettings& settings, const LitProgress& progress,
                                  const std::string& stage, const std::string& unit) {
  reference::RunOptions run;
  run.jobs = settings.jobs;
  run.progress = [&progress, stage, unit](double done, double total) { progress(stage, done, total, unit); };
  return run;
}

// Returns the visibility of the sun from the far side of translucent surfaces that the camera sees against
// the sun.
std::vector<float> visibility_behind(const scene::Scene& scene, const SeenMaterials& seen,
                                     const glm::vec3& to_sun, const LitSettings& settings,
                                     const reference::RunOptions& run) {
  scene::Receivers behind;
  behind.width = seen.width;
  behind.height = seen.height;
  behind.position_ws.resize(seen.points.size(), glm::vec4(0.0F));
  behind.position_relative.resize(seen.points.size(), glm::vec4(0.0F));
  behind.normal_ws.resize(seen.points.size(), glm::vec4(0.0F));
  bool any = false;
  for (std::size_t pixel = 0; pixel < seen.points.size(); ++pixel) {
    const SurfacePoint& point = seen.points[pixel];
    if (seen.seen[pixel] == 0 || point.translucency == 0.0F || glm::dot(point.flat_normal, to_sun) >= 0.0F)
      continue;
    behind.position_relative[pixel] = glm::vec4(point.position, 1.0F);
    behind.position_ws[pixel] = glm::vec4(point.position + glm::vec3(scene.origin), 1.0F);
    behind.normal_ws[pixel] = glm::vec4(-point.flat_normal, 0.0F);
    any = true;
  }
  if (!any) return std::vector<float>(seen.points.size(), 1.0F);
  const parameters::Light light{scene.light_direction, settings.light_degrees};
  const reference::ReferenceCache cache(settings.cache);
  return reference::trace_visibility(scene, behind, light, {settings.sun_rays, settings.seed}, run, &cache)
      .visibility;
}

}  // namespace

LitFrame::LitFrame(const scene::Scene& scene, const scene::Frame& frame, const LitSettings& settings,
                   const LitProgress& progress)
    : supersampling_(settings.supersampling) {
  check(frame.settings, supersampling_);
  width_ = frame.settings.width / supersampling_;
  height_ = frame.settings.height / supersampling_;
  const SeenMaterials seen = seen_materials(scene, frame);
  const Daylight day(-glm::normalize(scene.light_direction), settings.turbidity);
  const SkyDome dome([&](const glm::dvec3& direction) { return day.sky(direction); });
  const Sunlight sun{glm::vec3(day.to_sun()), glm::vec3(day.sun())};

  const std::string& name = scene.name;
  const int rays = std::max(settings.sky_rays / (supersampling_ * supersampling_), 1);
  const std::vector<glm::vec3> sky = smoothed(
      seen,
      kept_sky_light(scene, seen, {dome, sun.to_sun, sun.irradiance}, rays, settings.cache,
                     run_options(settings, progress, "sky light of " + name, " rows")),
      kSmoothingPasses, run_options(settings, progress, "smoothing the sky light of " + name, " rows"));
  const std::vector<float> behind =
      visibility_behind(scene, seen, sun.to_sun, settings,
                        run_options(settings, progress, "light through leaves of " + name, " rays"));

  const double white = glm::dot(day.sun(), glm::dvec3(0.2126, 0.7152, 0.0722)) / std::numbers::pi;
  const auto exposure = static_cast<float>(kWhiteInTheSun * std::exp2(settings.exposure_stops) / white);
  by_sun_.resize(seen.points.size(), glm::vec3(0.0F));
  others_.resize(seen.points.size());
  receives_.resize(seen.points.size());
  for (std::size_t pixel = 0; pixel < seen.points.size(); ++pixel) {
    const SurfacePoint& point = seen.points[pixel];
    if (seen.seen[pixel] == 0) {
      others_[pixel] = exposure * dome.radiance(seen.view_direction[pixel]);
      continue;
    }
    const glm::vec3 to_camera = -seen.view_direction[pixel];
    by_sun_[pixel] = exposure * lit_by_sun(point, to_camera, sun);
    others_[pixel] =
        exposure * (lit_by_sky(point, to_camera, sky[pixel]) + behind[pixel] * lit_through(point, sun));
    receives_[pixel] = frame.receivers.position_ws[pixel].w > 0.5F ? 1 : 0;
  }
}

std::vector<glm::vec3> LitFrame::picture(std::span<const float> visibility) const {
  if (visibility.size() != by_sun_.size()) throw std::invalid_argument("the visibility is of another frame");
  std::vector<glm::vec3> colours(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  const int samples = supersampling_ * supersampling_;
  reference::for_each_row(height_, {}, [&](int row) {
    for (int column = 0; column < width_; ++column) {
      glm::vec3 sum(0.0F);
      for (int k = 0; k < samples; ++k) {
        const std::size_t sample = static_cast<std::size_t>(row * supersampling_ + k / supersampling_) *
                                       static_cast<std::size_t>(width_ * supersampling_) +
                                   static_cast<std::size_t>(column * supersampling_ + k % supersampling_);
        const float seen = visibility[sample] > 0.0F ? std::min(visibility[sample], 1.0F) : 0.0F;
        sum += tone_mapped(others_[sample] + by_sun_[sample] * (receives_[sample] != 0 ? seen : 1.0F));
      }
      const glm::vec3 mean = sum / float(samples);
      colours[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
              static_cast<std::size_t>(column)] = {srgb_encoded(mean.r), srgb_encoded(mean.g),
                                                   srgb_encoded(mean.b)};
    }
  });
  return colours;
}

}  // namespace penumbra::lighting
