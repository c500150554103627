#include "study/study.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "input/input_error.h"
#include "parameters/settings_input.h"
#include "platform/hashed_fields.h"
#include "platform/interrupt.h"
#include "reference/reference_cache.h"
#include "reference/shadow_overlaps.h"
#include "resolve/debug_view.h"
#include "resolve/graph_resources.h"
#include "study/case_setup.h"
#include "study/colour_map.h"
#include "study/kept_records.h"
#include "study/lit_difference.h"
#include "study/prepared_subject.h"
#include "study/recording.h"

namespace penumbra::study {
namespace {

constexpr double kForgotten = 0.01;
constexpr int kFramesBetween = 7;

// Returns the number of frames before the first result, and that of the result itself.
int first_frames(double share) {
  if (!(share > 0.0 && share <= 1.0)) throw std::invalid_argument("a share of a history is above 0, up to 1");
  if (share == 1.0) return 1;
  return 1 + static_cast<int>(std::ceil(std::log(kForgotten) / std::log1p(-share)));
}

int frames_between(double share) {
  return share == 1.0 ? 1 : kFramesBetween;
}

// Checked before the first picture: the last subject may be the one that the map does not fit.
void check_map(const std::vector<Subject>& subjects, const StudySettings& settings) {
  const parameters::ShadowSettings& shadows = settings.frame.shadows;
  const parameters::AtlasLayout atlas = parameters::atlas_layout(shadows.resolution, shadows.cascades);
  for (const Subject& subject : subjects)
    resolve::require_whole_tiles(subject.graph.graph, subject.name, atlas.tile_resolution,
                                 atlas.width / atlas.tile_resolution);
}

// A GPU lowers its clock while it waits for the CPU to evaluate a picture, and needs tenths of a second of
// work to raise it again: on an NVIDIA H100, two runs of one study differed by up to a factor of five without
// a warm-up.
constexpr double kWarmUpSeconds = 0.5;

// Every setting is named, so that a new one does not compile before its place is decided. The hash has those
// settings on which records depend beyond the keys of views, subjects and debug views.
void add_settings(platform::ContentHash& hash, const StudySettings& settings) {
  const auto& [scenes, light_degrees, frame, penumbra_pixels, reference_samples, seed, noise_seeds,
               timing_repeats, split_error, overlaps, flip, pictures, pan_frames, frames, frame_step,
               edge_samples, window, debug_views, answered, bake, jobs, compiler, cache] = settings;
  const auto add = [&](const auto&... values) { (platform::add_all(hash, values), ...); };
  add(reference_samples, seed, noise_seeds, timing_repeats, split_error, overlaps, flip, pictures, pan_frames,
      frames, frame_step, edge_samples, window);
}

class Study {
 public:
  Study(gpu::Device& device, const std::vector<Subject>& subjects, const StudySettings& settings,
        const StudyProgress& progress)
      : device_(device),
        settings_(settings),
        progress_(progress),
        cache_(settings.cache),
        kept_(std::make_shared<KeptRecords>(settings.cache)),
        cases_(device, subjects, settings, progress, cache_) {
    check_map(subjects, settings);
    prepare(subjects);
  }

  StudyOutcome run() {
    for (const scene::Scene& scene : settings_.scenes) {
      scene::Rasteriser rasteriser(device_, scene);
      for (const double degrees : settings_.light_degrees) {
        const CaseSetup setup = cases_.build(scene, rasteriser, degrees);
        lit_.reset();
        overlaps_.reset();
        note_little_penumbra(setup);
        outcome_.frames.push_back(measured_frame(setup));
        for (std::size_t i = 0; i < subjects_.size(); ++i) {
          const Subject& subject = subjects_[i].subject();
          progress_(setup.label() + ", " + subject.name, static_cast<double>(i),
                    static_cast<double>(subjects_.size()), " techniques");
          const View& view = setup.view(FrameRequest::of(subject));
          add(setup, view, subjects_[i]);
          platform::throw_if_interrupted();
        }
      }
    }
    outcome_.kept = kept_;
    return std::move(outcome_);
  }

 private:
  void prepare(const std::vector<Subject>& subjects) {
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      progress_("compiling " + subjects[i].name, static_cast<double>(i), static_cast<double>(subjects.size()),
                " techniques");
      subjects_.emplace_back(device_, subjects[i], settings_);
      platform::throw_if_interrupted();
    }
    if (settings_.debug_views.empty()) return;
    const shaders::PackageShader views(shaders::debug_shader_file());
    for (const std::string& view : settings_.debug_views) {
      debug_views_.try_emplace(view, device_, views, view, settings_.frame.shadows.reversed_z,
                               settings_.compiler);
    }
  }

  void note_little_penumbra(const CaseSetup& setup) {
    const std::size_t found = penumbra_pixels(setup.t1);
    if (found >= static_cast<std::size_t>(settings_.penumbra_pixels)) return;
    outcome_.notes.push_back(setup.label() + " has " + std::to_string(found) +
                             " penumbra pixels, fewer than the " + std::to_string(settings_.penumbra_pixels) +
                             " requested");
  }

  // Takes the record that an interrupted run has measured, or measures it now.
  void add(const CaseSetup& setup, const View& view, PreparedSubject& prepared) {
    const bool kept = !settings_.answered;  // a callback needs the answer itself
    const std::string key = kept ? record_key(view, prepared) : std::string();
    if (std::optional<KeptRecord> known = kept ? kept_->find(key) : std::nullopt) {
      outcome_.records.push_back(std::move(known->record));
      outcome_.pictures.push_back(std::move(known->pictures));
      note_unset(prepared.subject(), known->unset_uniforms);
      return;
    }
    const std::vector<std::string> unset = measure_subject(setup, view, prepared);
    if (!view.pan.empty() && prepared.subject().history == 1.0)
      outcome_.records.back().shimmer = prepared.shimmer(setup, view);
    if (kept)
      kept_->store(key, {outcome_.frames.back(), outcome_.records.back(), outcome_.pictures.back(), unset});
  }

  std::string record_key(const View& view, const PreparedSubject& prepared) const {
    platform::ContentHash hash;
    platform::add_all(hash, view.key);
    platform::add_all(hash, prepared.key());
    add_settings(hash, settings_);
    for (const auto& [name, debug_view] : debug_views_) hash.update(name).update(debug_view.key());
    return hash.hex();
  }

  // Returns the uniforms that nobody provides.
  std::vector<std::string> measure_subject(const CaseSetup& setup, const View& view,
                                           PreparedSubject& prepared) {
    const Subject& subject = prepared.subject();
    const bool averaged = subject.averaged_frames > 1;
    resolve::RunOptions options;
    options.noise_seeds =
        averaged ? subject.averaged_frames : history_frames(subject.history, settings_.noise_seeds);
    options.timing_repeats = settings_.timing_repeats;
    options.count_fetches = true;
    if (!device_.info().is_software) options.warm_up_seconds = kWarmUpSeconds;
    options.earlier = prepared.earlier_frames(view);
    Answer answer = prepared.answer(view.on_device_frame, options);
    if (averaged) answer.visibility = {mean_image(answer.visibility)};
    if (subject.history < 1.0 && answer.visibility.size() > 1)
      answer.visibility = histories(answer.visibility, subject.history, settings_.noise_seeds);
    outcome_.records.push_back(record_of(setup, view, subject, answer, settings_.window,
                                         prepared.unlimited_answer(setup, view, cache_),
                                         device_.info().name));
    if (settings_.overlaps) outcome_.records.back().overlap = overlap_record(setup, answer, overlaps(setup));
    if (settings_.flip) outcome_.records.back().flip = lit(setup).of(answer.visibility.front());
    outcome_.pictures.push_back(settings_.pictures ? pictures_of(setup, subject, answer) : PictureRow{});
    if (subject.graph.graph.over_screen())
      outcome_.pictures.back().debug_views =
          debug_views(view.on_device_frame, subject.graph.parameters, answer);
    if (settings_.answered) {
      settings_.answered(
          {setup.scene, view.frame, setup.t1, outcome_.records.back(), answer.visibility.front()});
    }
    note_unset(subject, answer.unset_uniforms);
    return answer.unset_uniforms;
  }

  const std::vector<std::uint8_t>& overlaps(const CaseSetup& setup) {
    if (!overlaps_)
      overlaps_ = reference::shadow_overlaps(setup.scene, setup.views.front().frame.receivers,
                                             {setup.scene.light_direction, setup.light_degrees}, setup.t1,
                                             settings_.jobs);
    return *overlaps_;
  }

  // It is made with the first subject of a case that is measured anew: it takes long, and much memory.
  const LitDifference& lit(const CaseSetup& setup) {
    if (!lit_)
      lit_.emplace(setup.scene, setup.views.front().frame, setup.t1.visibility, setup.light_degrees,
                   settings_, progress_);
    return *lit_;
  }

  std::map<std::string, PackedPicture> debug_views(const FrameOfCase& frame,
                                                   const resolve::UniformValues& parameters,
                                                   const Answer& answer) {
    std::map<std::string, PackedPicture> pictures;
    for (auto& [name, view] : debug_views_) {
      const std::vector<glm::vec3> colours =
          view.draw(frame.on_device, *frame.camera, answer.visibility.front(), answer.masked_out, parameters);
      pictures.emplace(name, colour_picture(frame.camera->width, frame.camera->height, colours));
    }
    return pictures;
  }

  void note_unset(const Subject& subject, const std::vector<std::string>& uniforms) {
    if (uniforms.empty()) return;
    std::string note = subject.name + " reads uniforms that are not provided and are therefore 0:";
    for (const std::string& name : uniforms) note += " " + name;
    if (std::find(outcome_.notes.begin(), outcome_.notes.end(), note) == outcome_.notes.end()) {
      outcome_.notes.push_back(std::move(note));
    }
  }

  gpu::Device& device_;
  const StudySettings& settings_;
  const StudyProgress& progress_;
  reference::ReferenceCache cache_;
  std::shared_ptr<KeptRecords> kept_;
  CaseBuilder cases_;
  std::vector<PreparedSubject> subjects_;
  std::map<std::string, resolve::DebugView> debug_views_;  // keyed by pass
  std::optional<std::vector<std::uint8_t>> overlaps_;      // of the case that is measured
  std::optional<LitDifference> lit_;                       // of the case that is measured
  StudyOutcome outcome_;
};

}  // namespace

StudyOutcome run_study(gpu::Device& device, const std::vector<Subject>& subjects,
                       const StudySettings& settings, const StudyProgress& progress) {
  return Study(device, subjects, settings, progress).run();
}

int history_frames(double share, int results) {
  return first_frames(share) + frames_between(share) * (results - 1);
}

std::vector<std::vector<float>> histories(const std::vector<std::vector<float>>& frames, double share,
                                          int results) {
  if (results < 1 || static_cast<int>(frames.size()) != history_frames(share, results))
    throw std::invalid_argument("another number of frames than the history needs");
  const auto first = static_cast<std::size_t>(first_frames(share) - 1);
  const auto between = static_cast<std::size_t>(frames_between(share));
  std::vector<double> history(frames.front().begin(), frames.front().end());
  std::vector<std::vector<float>> images;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (frames[k].size() != history.size())
      throw std::invalid_argument("the frames of a history differ in size");
    for (std::size_t i = 0; i < history.size(); ++i)
      history[i] += share * (static_cast<double>(frames[k][i]) - history[i]);
    if (k >= first && (k - first) % between == 0) images.emplace_back(history.begin(), history.end());
  }
  return images;
}

Subject technique_subject(const techniques::TechniqueList& list, const techniques::Technique& technique,
                          bool reversed_z) {
  if (!technique.is_for(techniques::LightKind::directional))
    throw InputError("", "the technique '" + technique.name + "' is for spot lights, and scenes have a sun",
                     "choose others; 'penumbra validate' and 'cost' know this one");
  Subject subject;
  subject.name = technique.name;
  subject.title = technique.title;
  subject.parameters = technique.values;
  subject.cascades = technique.cascades;
  subject.bias = {technique.bias.depth, technique.bias.normal,
                  parameters::soft_quality_named(technique.bias.soft_quality)};
  subject.raster_bias.slope = technique.bias.slope;
  subject.graph = resolve::technique_graph(list, technique, resolve::Taps::as_listed, reversed_z);
  if (technique.is_sampled()) {
    subject.unlimited = resolve::technique_graph(list, technique, resolve::Taps::unlimited, reversed_z);
  }
  return subject;
}

Subject adapter_subject(const resolve::Adapter& adapter, bool reversed_z) {
  Subject subject;
  subject.name = adapter.name;
  subject.title = adapter.name + " (" + adapter.file.filename().string() + ")";
  subject.bias = adapter.bias;
  subject.light_scale = adapter.light_scale;
  subject.graph = resolve::adapter_graph(adapter, reversed_z);
  return subject;
}

}  // namespace penumbra::study
