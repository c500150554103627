#include "study/study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "input/input_error.h"
#include "parameters/settings_input.h"
#include "platform/content_hash.h"
#include "platform/interrupt.h"
#include "reference/reference_cache.h"
#include "reference/same_map_estimate.h"
#include "reference/trace_visibility.h"
#include "resolve/debug_view.h"
#include "resolve/resolve.h"
#include "resolve/screen_technique.h"
#include "scene/content_hash.h"
#include "study/colour_map.h"
#include "study/metrics.h"

namespace penumbra::study {
namespace {

using reference::VisibilityImage;

// Version of what is stored under unlimited_key: raise it when the meaning of T3 changes.
constexpr int kUnlimitedVersion = 1;
constexpr int kUnlimitedSeeds = 4;  // rotations averaged: thousands of taps leave little for them to do

// Of the picture's size each way, so that its area doubles from step to step; and where it ends.
constexpr std::array kPictureSteps{1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0};
constexpr int kLargestWidth = 3840;
constexpr int kLargestHeight = 2160;
constexpr int kPilotSamples = 64;
constexpr double kPilotMargin =
    1.2;  // the pilot counts are off by a few per cent, and the penumbra's by its edges

constexpr double kErrorScale = 0.5;
constexpr double kFetchScale = 128.0;

// What one subject said of one stage.
struct Answer {
  resolve::ResolveResult image;
  double fetches_of_others = 0.0;           // of passes at lower resolution, per pixel
  std::vector<float> fetches_of_others_at;  // the same at each pixel; empty without such passes
  std::vector<std::uint8_t> masked_out;
};

// A frame on the device, and as the camera's depth image for passes over the screen.
struct StagedFrame {
  resolve::FrameOnDevice on_device;
  resolve::CameraImage camera;
};

struct PreparedSubject {
  const Subject* subject;
  std::optional<resolve::Resolver> resolver;  // this or
  std::optional<resolve::ScreenChain> chain;  // that
  std::optional<resolve::CompiledShadowShader> unlimited;
  std::optional<resolve::Resolver> unlimited_resolver;
};

// What a subject asks of the frame that it is shown.
struct Wishes {
  parameters::CasterBias bias;
  double light_scale = 1.0;

  bool operator==(const Wishes&) const = default;
};

// A scene under a light as all subjects of the same wishes see it.
struct View {
  Wishes wishes;
  scene::Frame frame;
  StagedFrame staged;
  std::vector<StagedFrame> pan;
  std::optional<VisibilityImage> t2;
  std::string key;  // of scene, light, map and receivers
};

// Everything known about one scene under one light before the first subject is asked. Receivers, and with
// them T1, are those of every view.
struct Stage {
  const scene::Scene& scene;
  double light_degrees = 0.0;
  VisibilityImage t1;
  std::vector<View> views;  // by the wishes of subjects, each once
  int width = 0;            // of the picture
  int height = 0;

  const View& view(const Wishes& wishes) const {
    return *std::find_if(views.begin(), views.end(), [&](const View& view) { return view.wishes == wishes; });
  }
};

Wishes wishes_of(const Subject& subject) {
  return {subject.bias, subject.light_scale};
}

std::string map_format_name(scene::DepthFormat format) {
  switch (format) {
    case scene::DepthFormat::d16:
      return "D16";
    case scene::DepthFormat::d24:
      return "D24";
    case scene::DepthFormat::d32:
      break;
  }
  return "D32";
}

std::string stage_key(const scene::Scene& scene, const scene::Frame& frame) {
  platform::ContentHash hash;
  hash.update(scene::content_hash(scene)).update(frame.settings.angular_diameter_degrees);
  hash.update(std::span<const std::byte>(frame.atlas.texels));
  hash.update(std::span<const glm::vec4>(frame.receivers.position_ws));
  hash.update(std::span<const glm::vec4>(frame.receivers.normal_ws));
  return hash.hex();
}

std::string unlimited_key(const View& view, const resolve::CompiledShadowShader& shader) {
  platform::ContentHash hash;
  hash.update(kUnlimitedVersion).update(view.key).update(std::span<const std::uint32_t>(shader.plain));
  hash.update(shader.source.parameters.fingerprint());
  return hash.hex();
}

std::size_t penumbra_pixels(const VisibilityImage& image) {
  std::size_t count = 0;
  for (std::size_t pixel = 0; pixel < image.visibility.size(); ++pixel) {
    const double visibility = image.visibility[pixel];
    count += image.valid[pixel] != 0 && visibility >= kUmbraBelow && visibility <= kLitAbove ? 1U : 0U;
  }
  return count;
}

std::vector<float> mean_image(const std::vector<std::vector<float>>& images) {
  std::vector<float> mean(images.front().size());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    double sum = 0.0;
    for (const std::vector<float>& image : images) sum += image[i];
    mean[i] = static_cast<float>(sum / static_cast<double>(images.size()));
  }
  return mean;
}

Answer answer_of(PreparedSubject& prepared, const StagedFrame& frame,
                 const resolve::ResolveOptions& options) {
  if (prepared.resolver) return {prepared.resolver->resolve(frame.on_device, options), 0.0, {}, {}};
  resolve::ScreenChainResult result = prepared.chain->run(frame.on_device, frame.camera, options);
  return {std::move(result.image), result.fetches_of_others, std::move(result.fetches_of_others_at),
          std::move(result.masked_out)};
}

VisibilityImage unlimited_answer(const Stage& stage, const View& view, PreparedSubject& prepared,
                                 const reference::ReferenceCache& cache) {
  const resolve::FrameOnDevice& frame = view.staged.on_device;
  const std::string key = unlimited_key(view, *prepared.unlimited);
  if (std::optional<VisibilityImage> kept = cache.find(key)) return *std::move(kept);
  resolve::ResolveOptions options;
  options.noise_seeds = kUnlimitedSeeds;
  options.timing_repeats = 0;
  options.count_fetches = false;
  VisibilityImage answer;
  answer.width = frame.width();
  answer.height = frame.height();
  answer.visibility = mean_image(prepared.unlimited_resolver->resolve(frame, options).visibility);
  answer.valid = stage.t1.valid;
  answer.samples = kUnlimitedSeeds;
  cache.store(key, answer);
  return answer;
}

// The mean over frames becomes the one answer.
void average(std::vector<std::vector<float>>& frames) {
  frames = {mean_image(frames)};
}

// Receivers inside of the window alone.
std::vector<std::uint8_t> counted_receivers(const VisibilityImage& t1,
                                            const std::optional<PictureWindow>& window) {
  std::vector<std::uint8_t> counted = t1.valid;
  if (!window) return counted;
  for (std::size_t i = 0; i < counted.size(); ++i) {
    const int x = static_cast<int>(i) % t1.width;
    const int y = static_cast<int>(i) / t1.width;
    if (!window->contains(x, y)) counted[i] = 0;
  }
  return counted;
}

double fetches_of_others(const Answer& answer, int width, const std::optional<PictureWindow>& window) {
  if (!window || answer.fetches_of_others_at.empty()) return answer.fetches_of_others;
  double sum = 0.0;
  for (int y = window->y; y < window->y + window->height; ++y) {
    const auto row = answer.fetches_of_others_at.begin() + static_cast<std::ptrdiff_t>(y) * width + window->x;
    sum = std::accumulate(row, row + window->width, sum);
  }
  return sum / (static_cast<double>(window->width) * window->height);
}

// Of every pass at each pixel.
std::vector<std::uint32_t> all_fetches(const Answer& answer) {
  std::vector<std::uint32_t> all = answer.image.fetches;
  for (std::size_t i = 0; i < answer.fetches_of_others_at.size(); ++i) {
    all[i] += static_cast<std::uint32_t>(std::lround(answer.fetches_of_others_at[i]));
  }
  return all;
}

Picture mask_picture(const PixelGrid& grid, const std::vector<std::uint8_t>& masked_out) {
  std::vector<float> runs;
  runs.reserve(masked_out.size());
  for (const std::uint8_t left_out : masked_out) runs.push_back(left_out != 0 ? 0.0F : 1.0F);
  return visibility_picture(grid, runs);
}

RunSettings run_settings(const View& view) {
  const parameters::ShadowSettings& shadows = view.frame.settings.shadows;
  RunSettings settings;
  settings.depth_bias = shadows.depth_bias;
  settings.normal_bias = shadows.normal_bias;
  settings.soft_quality = shadows.soft_quality;
  settings.constant_bias = view.frame.settings.raster_bias.constant;
  settings.slope_bias = view.frame.settings.raster_bias.slope;
  settings.light_scale = view.wishes.light_scale;
  settings.reversed_z = shadows.reversed_z;
  const std::array<double, 3> splits = parameters::effective_splits(shadows);
  settings.splits.assign(splits.begin(), splits.begin() + (shadows.cascades - 1));
  return settings;
}

MeasuredFrame measured_frame(const Stage& stage) {
  const scene::Frame& frame = stage.views.front().frame;
  MeasuredFrame note;
  note.scene = stage.scene.name;
  note.light_degrees = stage.light_degrees;
  note.sun_direction = frame.cascades.light_direction;
  note.width = stage.t1.width;
  note.height = stage.t1.height;
  note.shadow_distance_metres = frame.settings.shadows.distance_metres;
  note.camera = frame.camera;
  return note;
}

PictureRow pictures(const Stage& stage, const Subject& subject, const Answer& answer) {
  const resolve::ResolveResult& result = answer.image;
  const PixelGrid grid{stage.t1.width, stage.t1.height, stage.t1.valid};
  PictureRow row;
  row.scene = stage.scene.name;
  row.technique = subject.name;
  row.light_degrees = stage.light_degrees;
  row.reference = visibility_picture(grid, stage.t1.visibility);
  row.result = visibility_picture(grid, result.visibility.front());
  row.error = error_picture(grid, result.visibility.front(), stage.t1.visibility, kErrorScale);
  row.fetches = fetch_picture(grid, all_fetches(answer), kFetchScale);
  row.fetch_counts = count_picture(grid, all_fetches(answer));
  if (!answer.masked_out.empty()) row.mask = mask_picture(grid, answer.masked_out);
  row.error_scale = kErrorScale;
  row.fetch_scale = kFetchScale;
  return row;
}

Metrics metrics_of(const Stage& stage, const View& view, const Answer& answer,
                   const std::optional<PictureWindow>& window,
                   const std::optional<VisibilityImage>& unlimited) {
  const resolve::ResolveResult& result = answer.image;
  MeasuredImages images;
  const std::vector<std::uint8_t> counted = counted_receivers(stage.t1, window);
  images.preprocess_fetches_per_pixel = fetches_of_others(answer, stage.t1.width, window);
  images.masked_out = answer.masked_out;
  images.width = stage.t1.width;
  images.t1 = stage.t1.visibility;
  images.valid = counted;
  for (const std::vector<float>& image : result.visibility) images.results.emplace_back(image);
  images.fetches.emplace_back(result.fetches);
  if (view.t2) {
    images.t2 = view.t2->visibility;
    images.t3 = unlimited ? std::span<const float>(unlimited->visibility) : images.results.front();
  }
  return measure(images);
}

class Study {
 public:
  Study(gpu::Device& device, const std::vector<Subject>& subjects, const StudySettings& settings,
        const StudyProgress& progress)
      : device_(device), settings_(settings), progress_(progress), cache_(settings.cache) {
    prepare(subjects);
  }

  StudyOutcome run() {
    for (const scene::Scene& scene : settings_.scenes) {
      scene::Rasteriser rasteriser(device_, scene);
      for (const double degrees : settings_.light_degrees) {
        const Stage stage = set_stage(scene, rasteriser, degrees);
        outcome_.frames.push_back(measured_frame(stage));
        for (std::size_t i = 0; i < subjects_.size(); ++i) {
          progress_(label(stage) + ", " + subjects_[i].subject->name, static_cast<double>(i),
                    static_cast<double>(subjects_.size()), " techniques");
          const View& view = stage.view(wishes_of(*subjects_[i].subject));
          measure_subject(stage, view, subjects_[i]);
          if (!view.pan.empty()) outcome_.records.back().shimmer = shimmer(stage, view.pan, subjects_[i]);
          platform::throw_if_interrupted();
        }
      }
    }
    return std::move(outcome_);
  }

 private:
  void prepare(const std::vector<Subject>& subjects) {
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      const Subject& subject = subjects[i];
      progress_("compiling " + subject.name, static_cast<double>(i), static_cast<double>(subjects.size()),
                " techniques");
      PreparedSubject prepared{&subject, std::nullopt, std::nullopt, std::nullopt, std::nullopt};
      if (subject.screen) {
        prepared.chain.emplace(device_, package_shader(), *subject.screen,
                               settings_.frame.shadows.reversed_z);
      } else {
        prepared.resolver.emplace(device_, resolve::compile(subject.shader));
      }
      if (settings_.split_error && subject.unlimited) {
        prepared.unlimited = resolve::compile(*subject.unlimited);
        prepared.unlimited_resolver.emplace(device_, *prepared.unlimited);
      }
      subjects_.push_back(std::move(prepared));
      platform::throw_if_interrupted();
    }
    if (settings_.debug_views.empty()) return;
    const shaders::PackageShader views(shaders::debug_shader_file());
    for (const std::string& view : settings_.debug_views) {
      debug_views_.try_emplace(view, device_, views, view, settings_.frame.shadows.reversed_z);
    }
  }

  // Parsed once, when a subject needs it.
  const shaders::PackageShader& package_shader() {
    if (!package_shader_) package_shader_.emplace(shaders::package_shader_file());
    return *package_shader_;
  }

  // The camera's image only for those who read it.
  StagedFrame staged(const scene::Frame& frame) const {
    const bool read = std::any_of(subjects_.begin(), subjects_.end(),
                                  [](const PreparedSubject& subject) { return subject.chain.has_value(); });
    return {{device_, frame}, read ? resolve::camera_image(frame) : resolve::CameraImage{}};
  }

  static std::string label(const Stage& stage) {
    std::string degrees = std::to_string(stage.light_degrees);
    degrees.erase(degrees.find_last_not_of('0') + 1);
    if (degrees.back() == '.') degrees.pop_back();
    return stage.scene.name + " at " + degrees + " degrees";
  }

  Stage set_stage(const scene::Scene& scene, scene::Rasteriser& rasteriser, double degrees) {
    Stage stage{scene, degrees, {}, {}, settings_.frame.width, settings_.frame.height};
    if (settings_.penumbra_pixels > 0) enlarge(stage, rasteriser);
    for (const PreparedSubject& prepared : subjects_)
      add_view(stage, rasteriser, wishes_of(*prepared.subject));
    const parameters::Light light{scene.light_direction, degrees};
    const reference::TraceOptions trace{settings_.reference_samples, settings_.seed};
    stage.t1 = reference::trace_visibility(scene, stage.views.front().frame.receivers, light, trace,
                                           run_options("ray tracing " + label(stage), " rays"), &cache_);
    note_little_penumbra(stage);
    if (settings_.split_error) {
      for (View& view : stage.views) view.t2 = same_map_estimate(stage, rasteriser, view);
    }
    return stage;
  }

  // A few rays a pixel of the smallest picture tell how much penumbra there is; it grows with the picture's
  // area.
  void enlarge(Stage& stage, scene::Rasteriser& rasteriser) const {
    const scene::Frame frame = rasteriser.frame(frame_settings(stage, {}));
    const parameters::Light light{stage.scene.light_direction, stage.light_degrees};
    const VisibilityImage pilot =
        reference::trace_visibility(stage.scene, frame.receivers, light, {kPilotSamples, settings_.seed},
                                    run_options("sizing " + label(stage), " rays"), &cache_);
    const double wanted = kPilotMargin * settings_.penumbra_pixels;
    const auto found = static_cast<double>(penumbra_pixels(pilot));
    if (found == 0.0) return;
    const int width = stage.width;
    const int height = stage.height;
    for (const double factor : kPictureSteps) {
      const auto wider = static_cast<int>(factor * width);
      const auto taller = static_cast<int>(factor * height);
      if (wider > kLargestWidth || taller > kLargestHeight) return;
      stage.width = wider;
      stage.height = taller;
      if (factor * factor * found >= wanted) return;
    }
  }

  void note_little_penumbra(const Stage& stage) {
    const std::size_t found = penumbra_pixels(stage.t1);
    if (found >= static_cast<std::size_t>(settings_.penumbra_pixels)) return;
    outcome_.notes.push_back(label(stage) + " has " + std::to_string(found) +
                             " penumbra pixels, fewer than the " + std::to_string(settings_.penumbra_pixels) +
                             " requested");
  }

  scene::FrameSettings frame_settings(const Stage& stage, const Wishes& wishes) const {
    scene::FrameSettings frame = settings_.frame;
    frame.width = stage.width;
    frame.height = stage.height;
    frame.angular_diameter_degrees = wishes.light_scale * stage.light_degrees;
    frame.shadows.distance_metres = stage.scene.shadow_distance_metres;
    frame.shadows.depth_bias = wishes.bias.depth;
    frame.shadows.normal_bias = wishes.bias.normal;
    frame.shadows.soft_quality = wishes.bias.soft_quality;
    return frame;
  }

  void add_view(Stage& stage, scene::Rasteriser& rasteriser, const Wishes& wishes) const {
    const bool known = std::any_of(stage.views.begin(), stage.views.end(),
                                   [&](const View& view) { return view.wishes == wishes; });
    if (known) return;
    scene::Frame frame = rasteriser.frame(frame_settings(stage, wishes));
    StagedFrame on_device = staged(frame);
    std::vector<StagedFrame> pan = pan_frames(frame.settings, rasteriser);
    std::string key = stage_key(stage.scene, frame);
    stage.views.push_back(
        {wishes, std::move(frame), std::move(on_device), std::move(pan), std::nullopt, std::move(key)});
  }

  // Of the light as it is, whatever the subjects were told.
  VisibilityImage same_map_estimate(const Stage& stage, scene::Rasteriser& rasteriser,
                                    const View& view) const {
    std::optional<scene::Frame> own;
    if (view.wishes.light_scale != 1.0)
      own = rasteriser.frame(frame_settings(stage, {view.wishes.bias, 1.0}));
    const scene::Frame& frame = own ? *own : view.frame;
    return reference::same_map_estimate({frame.atlas, frame.cascades, frame.receivers, stage.scene.origin},
                                        run_options("same-map estimate, " + label(stage), " points"),
                                        &cache_);
  }

  // The first is the view's own; each further one shows everything a pixel further left.
  std::vector<StagedFrame> pan_frames(const scene::FrameSettings& settings,
                                      scene::Rasteriser& rasteriser) const {
    std::vector<StagedFrame> frames;
    if (settings_.pan_frames < 2) return frames;
    for (int k = 0; k < settings_.pan_frames; ++k) {
      scene::FrameSettings moved = settings;
      moved.lens_shift.x += k * 2.0 / moved.width;
      const scene::Frame frame = rasteriser.frame(moved);
      frames.push_back(staged(frame));
    }
    return frames;
  }

  static Shimmer shimmer(const Stage& stage, const std::vector<StagedFrame>& pan, PreparedSubject& prepared) {
    const auto of = [&](bool noise_moves) {
      std::vector<std::vector<float>> pictures;
      for (std::size_t k = 0; k < pan.size(); ++k) {
        resolve::ResolveOptions options{.noise_seeds = 1, .timing_repeats = 0, .count_fetches = false};
        options.first_seed = noise_moves ? static_cast<int>(k) : 0;
        pictures.push_back(answer_of(prepared, pan[k], options).image.visibility.front());
      }
      return shimmer_of(pictures, stage.t1.width, stage.t1.visibility, stage.t1.valid);
    };
    return {static_cast<int>(pan.size()), of(false), of(true)};
  }

  reference::RunOptions run_options(const std::string& stage, const std::string& unit) const {
    reference::RunOptions options;
    options.jobs = settings_.jobs;
    options.progress = [this, stage, unit](double done, double total) {
      progress_(stage, done, total, unit);
    };
    return options;
  }

  void measure_subject(const Stage& stage, const View& view, PreparedSubject& prepared) {
    resolve::ResolveOptions options;
    const bool averaged = prepared.subject->averaged_frames > 1;
    options.noise_seeds = averaged ? prepared.subject->averaged_frames : settings_.noise_seeds;
    options.timing_repeats = settings_.timing_repeats;
    Answer answer = answer_of(prepared, view.staged, options);
    if (averaged) average(answer.image.visibility);
    std::optional<VisibilityImage> unlimited;
    if (prepared.unlimited) unlimited = unlimited_answer(stage, view, prepared, cache_);

    const Subject& subject = *prepared.subject;
    Record record;
    record.scene = stage.scene.name;
    record.technique = subject.name;
    record.title = subject.title;
    record.parameters = subject.parameters;
    record.light_degrees = stage.light_degrees;
    record.map_size = view.frame.atlas.width;
    record.map_format = map_format_name(view.frame.atlas.format);
    record.cascades = static_cast<int>(view.frame.cascades.cascades.size());
    record.settings = run_settings(view);
    record.device = device_.info().name;
    record.metrics = metrics_of(stage, view, answer, settings_.window, unlimited);
    std::vector<double> milliseconds = answer.image.time_ns;
    for (double& time : milliseconds) time *= 1e-6;
    record.time = summarise(std::move(milliseconds));
    record.reference = {"ray-traced disc light", stage.t1.samples, stage.t1.noise_floor};
    outcome_.records.push_back(std::move(record));
    outcome_.pictures.push_back(pictures(stage, subject, answer));
    if (subject.screen)
      outcome_.pictures.back().debug_views = debug_views(view.staged, *subject.screen, answer);
    if (settings_.answered) {
      settings_.answered(
          {stage.scene, view.frame, stage.t1, outcome_.records.back(), answer.image.visibility.front()});
    }
    note_unset(subject, answer.image);
  }

  std::map<std::string, Picture> debug_views(const StagedFrame& frame,
                                             const resolve::ScreenChainDescription& chain,
                                             const Answer& answer) {
    std::map<std::string, Picture> pictures;
    for (auto& [name, view] : debug_views_) {
      const std::vector<glm::vec3> colours =
          view.draw(frame.on_device, frame.camera, answer.image.visibility.front(), answer.masked_out,
                    chain.parameters);
      pictures.emplace(name, colour_picture(frame.camera.width, frame.camera.height, colours));
    }
    return pictures;
  }

  void note_unset(const Subject& subject, const resolve::ResolveResult& result) {
    if (result.unset_uniforms.empty()) return;
    std::string note = subject.name + " reads uniforms that are not provided and are therefore 0:";
    for (const std::string& name : result.unset_uniforms) note += " " + name;
    if (std::find(outcome_.notes.begin(), outcome_.notes.end(), note) == outcome_.notes.end()) {
      outcome_.notes.push_back(std::move(note));
    }
  }

  gpu::Device& device_;
  const StudySettings& settings_;
  const StudyProgress& progress_;
  reference::ReferenceCache cache_;
  std::optional<shaders::PackageShader> package_shader_;
  std::vector<PreparedSubject> subjects_;
  std::map<std::string, resolve::DebugView> debug_views_;  // by pass
  StudyOutcome outcome_;
};

}  // namespace

Subject technique_subject(const shaders::TechniqueList& list, const shaders::Technique& technique,
                          bool reversed_z) {
  Subject subject;
  subject.name = technique.name;
  subject.title = technique.title;
  subject.parameters = technique.values;
  subject.bias = {technique.bias.depth, technique.bias.normal,
                  parameters::soft_quality_named(technique.bias.soft_quality)};
  subject.shader = resolve::technique_shader(list, technique, resolve::Taps::as_listed, reversed_z);
  if (technique.screen) subject.screen = resolve::screen_chain(technique);
  if (!technique.unlimited.empty()) {
    subject.unlimited = resolve::technique_shader(list, technique, resolve::Taps::unlimited, reversed_z);
  }
  return subject;
}

Subject adapter_subject(const resolve::Adapter& adapter, bool reversed_z) {
  Subject subject;
  subject.name = adapter.name;
  subject.title = adapter.name + " (" + adapter.file.filename().string() + ")";
  subject.bias = adapter.bias;
  subject.light_scale = adapter.light_scale;
  subject.shader = resolve::adapter_shader(adapter, reversed_z);
  return subject;
}

StudyOutcome run_study(gpu::Device& device, const std::vector<Subject>& subjects,
                       const StudySettings& settings, const StudyProgress& progress) {
  return Study(device, subjects, settings, progress).run();
}

}  // namespace penumbra::study
