#include "study/case_setup.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "parameters/half_angle.h"
#include "platform/cache_store.h"
#include "platform/hashed_fields.h"
#include "reference/same_map_estimate.h"
#include "reference/trace_visibility.h"
#include "study/metrics.h"

namespace penumbra::study {
namespace {

// The offsets are in 16ths of a pixel.
constexpr std::array<std::array<int, 2>, 2> kTwo{{{4, 4}, {-4, -4}}};
constexpr std::array<std::array<int, 2>, 4> kFour{{{-2, -6}, {6, -2}, {-6, 2}, {2, 6}}};
constexpr std::array<std::array<int, 2>, 8> kEight{
    {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}}};

// These are smaller than what a technique may take for an edge, so that an edge that it does not mark counts
// here.
constexpr double kSmallestPixels = 0.5;  // apart, in pixel footprints
constexpr double kLargestCosine = 0.97;  // cosine of the angle between normals

template <std::size_t count>
std::vector<glm::dvec2> offsets_of(const std::array<std::array<int, 2>, count>& sixteenths) {
  std::vector<glm::dvec2> offsets;
  for (const std::array<int, 2>& place : sixteenths) offsets.emplace_back(place[0] / 16.0, place[1] / 16.0);
  return offsets;
}

// Returns whether two samples of one pixel see different surfaces. `metres` is the width of a pixel per metre
// of distance.
bool differ(const SampleView& a, const SampleView& b, std::size_t pixel, const parameters::Camera& camera,
            double metres) {
  if (a.receivers.triangle[pixel] == b.receivers.triangle[pixel]) return false;
  const glm::dvec3 normal(a.receivers.normal_ws[pixel]);
  const glm::dvec3 other(b.receivers.normal_ws[pixel]);
  if (glm::dot(normal, other) < kLargestCosine) return true;
  const glm::dvec3 at(a.receivers.position_ws[pixel]);
  const glm::dvec3 between = glm::dvec3(b.receivers.position_ws[pixel]) - at;
  const double apart = std::max(std::abs(glm::dot(between, normal)), std::abs(glm::dot(between, other)));
  return apart > kSmallestPixels * metres * glm::distance(at, camera.position);
}

bool all_seen(std::span<const SampleView> samples, std::size_t pixel) {
  return std::all_of(samples.begin(), samples.end(),
                     [pixel](const SampleView& sample) { return sample.traced.valid[pixel] != 0; });
}

// The growth factor of the picture's width and height, which doubles its area per step; and the limit.
constexpr std::array kPictureSteps{1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0};
constexpr int kLargestWidth = 3840;
constexpr int kLargestHeight = 2160;
constexpr int kPilotSamples = 64;
constexpr double kPilotMargin =
    1.2;  // the pilot counts are off by a few per cent, and the penumbra's by its edges

}  // namespace

std::size_t penumbra_pixels(const reference::VisibilityImage& image) {
  std::size_t count = 0;
  for (std::size_t pixel = 0; pixel < image.visibility.size(); ++pixel) {
    const double visibility = image.visibility[pixel];
    count += image.valid[pixel] != 0 && visibility >= kUmbraBelow && visibility <= kLitAbove ? 1U : 0U;
  }
  return count;
}

std::string CaseSetup::label() const {
  std::string degrees = std::to_string(light_degrees);
  degrees.erase(degrees.find_last_not_of('0') + 1);
  if (degrees.back() == '.') degrees.pop_back();
  return scene.name + " at " + degrees + " degrees";
}

CaseBuilder::CaseBuilder(const gpu::Device& device, const std::vector<Subject>& subjects,
                         const StudySettings& settings, const StudyProgress& progress,
                         const reference::ReferenceCache& cache)
    : device_(device),
      subjects_(subjects),
      settings_(settings),
      progress_(progress),
      cache_(cache),
      bakes_(settings.cache.empty() ? platform::cache_directory() : settings.cache) {}

CaseSetup CaseBuilder::build(const scene::Scene& scene, scene::Rasteriser& rasteriser, double degrees) const {
  CaseSetup setup{scene,
                  nullptr,
                  nullptr,
                  degrees,
                  {},
                  {},
                  settings_.frame.width,
                  settings_.frame.height,
                  settings_.edge_samples};
  if (std::any_of(subjects_.begin(), subjects_.end(),
                  [](const Subject& subject) { return subject.graph.graph.draws_casters(); }))
    setup.casters = casters_of(scene);
  setup.inputs = std::make_unique<const resolve::FrameInputs>(inputs_of(setup));
  if (settings_.penumbra_pixels > 0) enlarge(setup, rasteriser);
  for (const Subject& subject : subjects_) add_view(setup, rasteriser, FrameRequest::of(subject));
  setup.t1 = settings_.edge_samples > 0 ? traced_edges(setup, rasteriser)
                                        : traced(setup, setup.views.front().frame.receivers,
                                                 settings_.reference_samples, "ray tracing " + setup.label());
  // Maps do not reach beyond the shadow distance, so no estimate can be made from them there.
  if (settings_.split_error && scene.seen_distance_metres <= scene.shadow_distance_metres) {
    for (View& view : setup.views) view.t2 = same_map_estimate(setup, rasteriser, view);
  }
  return setup;
}

std::unique_ptr<const resolve::CastersOnDevice> CaseBuilder::casters_of(const scene::Scene& scene) const {
  auto casters = std::make_unique<resolve::CastersOnDevice>(device_, scene);
  if (std::any_of(subjects_.begin(), subjects_.end(), [](const Subject& subject) {
        return subject.graph.graph.draws(techniques::DrawnCasters::volumes);
      }))
    casters->add_volumes(device_, scene);
  return casters;
}

reference::VisibilityImage CaseBuilder::traced(const CaseSetup& setup, const scene::Receivers& receivers,
                                               int samples, const std::string& work) const {
  const reference::TraceOptions trace{samples, settings_.seed};
  const reference::RunOptions run = run_options(work, " rays");
  const parameters::Light light{setup.scene.light_direction, setup.light_degrees};
  reference::VisibilityImage image =
      reference::trace_visibility(setup.scene, receivers, light, trace, run, &cache_);
  reference::shade_by_clouds(image, setup.scene, receivers, light);
  return image;
}

// There is one picture for each sample of a pixel, taken at the sample's place.
reference::VisibilityImage CaseBuilder::traced_edges(const CaseSetup& setup,
                                                     scene::Rasteriser& rasteriser) const {
  std::vector<SampleView> samples;
  for (const glm::dvec2& offset : sample_offsets(settings_.edge_samples)) {
    scene::FrameSettings moved = setup.views.front().frame.settings;
    moved.lens_shift += glm::dvec2(2.0 * offset.x / moved.width, -2.0 * offset.y / moved.height);
    scene::Receivers receivers = rasteriser.frame(moved).receivers;
    const std::string work = "ray tracing " + setup.label() + ", sample " +
                             std::to_string(samples.size() + 1) + " of " +
                             std::to_string(settings_.edge_samples);
    reference::VisibilityImage image = traced(setup, receivers, settings_.reference_samples, work);
    samples.push_back({std::move(receivers), std::move(image)});
  }
  return edge_reference(samples, setup.views.front().frame.camera);
}

// A few rays per pixel of the smallest picture estimate the number of penumbra pixels, which grows with the
// picture's area.
void CaseBuilder::enlarge(CaseSetup& setup, scene::Rasteriser& rasteriser) const {
  const scene::Frame frame = rasteriser.frame(frame_settings(setup, {}));
  const reference::VisibilityImage pilot =
      traced(setup, frame.receivers, kPilotSamples, "sizing " + setup.label());
  const double wanted = kPilotMargin * settings_.penumbra_pixels;
  const auto found = static_cast<double>(penumbra_pixels(pilot));
  if (found == 0.0) return;
  const int width = setup.width;
  const int height = setup.height;
  for (const double factor : kPictureSteps) {
    const auto wider = static_cast<int>(factor * width);
    const auto taller = static_cast<int>(factor * height);
    if (wider > kLargestWidth || taller > kLargestHeight) return;
    setup.width = wider;
    setup.height = taller;
    if (factor * factor * found >= wanted) return;
  }
}

scene::FrameSettings CaseBuilder::frame_settings(const CaseSetup& setup, const FrameRequest& request) const {
  scene::FrameSettings frame = settings_.frame;
  frame.width = setup.width;
  frame.height = setup.height;
  frame.angular_diameter_degrees = request.light_scale * setup.light_degrees;
  frame.shadows.distance_metres = setup.scene.shadow_distance_metres;
  frame.shadows.depth_bias = request.bias.depth;
  frame.shadows.normal_bias = request.bias.normal;
  frame.shadows.soft_quality = request.bias.soft_quality;
  frame.raster_bias = request.raster_bias;
  frame.cascade_choices = request.cascade_choices;
  return frame;
}

void CaseBuilder::add_view(CaseSetup& setup, scene::Rasteriser& rasteriser,
                           const FrameRequest& request) const {
  const bool known = std::any_of(setup.views.begin(), setup.views.end(),
                                 [&](const View& view) { return view.request == request; });
  if (known) return;
  scene::Frame frame = rasteriser.frame(frame_settings(setup, request));
  FrameOfCase on_device = on_device_frame(setup, frame);
  std::vector<FrameOfCase> earlier = earlier_frames(setup, frame.settings, rasteriser);
  std::vector<FrameOfCase> pan = pan_frames(setup, frame.settings, rasteriser);
  std::string key = platform::hash_of(setup.scene, setup.light_degrees, frame, settings_.bake);
  setup.views.push_back({request, std::move(frame), std::move(on_device), std::move(earlier), std::move(pan),
                         std::nullopt, std::move(key)});
}

// The estimate is for the actual light, whatever diameter the subjects are given.
reference::VisibilityImage CaseBuilder::same_map_estimate(const CaseSetup& setup,
                                                          scene::Rasteriser& rasteriser,
                                                          const View& view) const {
  std::optional<scene::Frame> own;
  if (view.request.light_scale != 1.0) {
    FrameRequest actual = view.request;
    actual.light_scale = 1.0;
    own = rasteriser.frame(frame_settings(setup, actual));
  }
  const scene::Frame& frame = own ? *own : view.frame;
  return reference::same_map_estimate({frame.atlas, frame.cascades, frame.receivers, setup.scene.origin},
                                      run_options("same-map estimate, " + setup.label(), " points"), &cache_);
}

// Returns the frame in which everything lies so many pixels further to the left.
FrameOfCase CaseBuilder::moved_frame(const CaseSetup& setup, const scene::FrameSettings& settings,
                                     double pixels, scene::Rasteriser& rasteriser) const {
  scene::FrameSettings moved = settings;
  moved.lens_shift.x += pixels * 2.0 / moved.width;
  return on_device_frame(setup, rasteriser.frame(moved));
}

std::vector<FrameOfCase> CaseBuilder::earlier_frames(const CaseSetup& setup,
                                                     const scene::FrameSettings& settings,
                                                     scene::Rasteriser& rasteriser) const {
  std::vector<FrameOfCase> frames;
  const bool has_history = std::any_of(subjects_.begin(), subjects_.end(), [](const Subject& subject) {
    return subject.graph.graph.has_history();
  });
  for (int k = settings_.frames - 1; has_history && k > 0; --k)
    frames.push_back(moved_frame(setup, settings, -k * settings_.frame_step, rasteriser));
  return frames;
}

// The first frame is the view's own; in each further one everything moves one pixel to the left.
std::vector<FrameOfCase> CaseBuilder::pan_frames(const CaseSetup& setup, const scene::FrameSettings& settings,
                                                 scene::Rasteriser& rasteriser) const {
  std::vector<FrameOfCase> frames;
  if (settings_.pan_frames < 2) return frames;
  for (int k = 0; k < settings_.pan_frames; ++k)
    frames.push_back(moved_frame(setup, settings, k, rasteriser));
  return frames;
}

// Only subjects that read the camera's image get it.
FrameOfCase CaseBuilder::on_device_frame(const CaseSetup& setup, const scene::Frame& frame) const {
  const bool read = std::any_of(subjects_.begin(), subjects_.end(),
                                [](const Subject& subject) { return subject.graph.graph.needs_camera(); });
  return {{device_, frame, setup.casters.get(), setup.inputs.get()},
          read ? std::optional(resolve::camera_image(frame)) : std::nullopt};
}

resolve::FrameInputs CaseBuilder::inputs_of(const CaseSetup& setup) const {
  std::vector<techniques::Need> needs;
  for (const Subject& subject : subjects_)
    for (const techniques::Need need : subject.graph.graph.needs)
      if (std::find(needs.begin(), needs.end(), need) == needs.end()) needs.push_back(need);
  bake::BakeOptions run;
  run.jobs = settings_.jobs;
  run.store = &bakes_;
  run.progress = [&](double done, double total) {
    progress_("baking " + setup.scene.name, done, total, " rows");
  };
  return baked_inputs(device_, setup.scene, needs, settings_.bake, run);
}

reference::RunOptions CaseBuilder::run_options(const std::string& work, const std::string& unit) const {
  reference::RunOptions options;
  options.jobs = settings_.jobs;
  options.progress = [this, work, unit](double done, double total) { progress_(work, done, total, unit); };
  return options;
}

std::vector<glm::dvec2> sample_offsets(int samples) {
  if (samples == 2) return offsets_of(kTwo);
  if (samples == 4) return offsets_of(kFour);
  if (samples == 8) return offsets_of(kEight);
  throw std::invalid_argument("samples are 2, 4 or 8");
}

reference::VisibilityImage edge_reference(std::span<const SampleView> samples,
                                          const parameters::Camera& camera) {
  const reference::VisibilityImage& first = samples.front().traced;
  reference::VisibilityImage mean{first.width, first.height, {}, {}, 0.0, 0};
  mean.visibility.resize(first.visibility.size());
  mean.valid.resize(first.valid.size());
  const double metres = 2.0 * parameters::tan_half(camera.fov_y_degrees) / first.height;
  double squares = 0.0;
  for (const SampleView& sample : samples) {
    squares += sample.traced.noise_floor * sample.traced.noise_floor;
    mean.samples += sample.traced.samples;
  }
  mean.noise_floor = std::sqrt(squares) / static_cast<double>(samples.size());
  for (std::size_t pixel = 0; pixel < mean.valid.size(); ++pixel) {
    double sum = 0.0;
    for (const SampleView& sample : samples) sum += sample.traced.visibility[pixel];
    mean.visibility[pixel] = static_cast<float>(sum / static_cast<double>(samples.size()));
    if (!all_seen(samples, pixel)) continue;
    for (const SampleView& sample : samples.subspan(1))
      if (differ(samples.front(), sample, pixel, camera, metres)) mean.valid[pixel] = 1;
  }
  return mean;
}

}  // namespace penumbra::study
