#include "study/study.h"

#include <algorithm>
#include <map>
#include <optional>

#include "input/input_error.h"
#include "platform/hashed_fields.h"
#include "platform/interrupt.h"
#include "reference/reference_cache.h"
#include "resolve/debug_view.h"
#include "resolve/whole_tiles.h"
#include "study/case_setup.h"
#include "study/colour_map.h"
#include "study/history.h"
#include "study/kept_records.h"
#include "study/prepared_subject.h"
#include "study/recording.h"

namespace penumbra::study {
namespace {

techniques::LightKind kind_of(const scene::Scene& scene) {
  return scene.spot_light ? techniques::LightKind::spot : techniques::LightKind::directional;
}

std::string light_of(const scene::Scene& scene) {
  return "scene '" + scene.name + "' is lit by " + (scene.spot_light ? "a spot light" : "the sun");
}

void check_lights(const std::vector<scene::Scene>& scenes, const std::vector<Subject>& subjects,
                  const StudySettings& settings) {
  for (const scene::Scene& scene : scenes) {
    for (const Subject& subject : subjects) {
      if (subject.light == kind_of(scene)) continue;
      throw InputError("",
                       light_of(scene) + ", and '" + subject.name + "' runs for " +
                           (scene.spot_light ? "the sun" : "a spot light"),
                       "choose techniques for that kind of light, or other scenes");
    }
    if (scene.spot_light && settings.edge_samples > 0)
      throw InputError("", light_of(scene) + ", and edges are measured under the sun alone");
    if (!scene.spot_light || !settings.split_error) continue;
    throw InputError("", light_of(scene) + ", for whose maps there is no same-map estimate",
                     "leave out the split of the error: --no-split");
  }
}

// Checked before the first picture: the last subject may be the one that the map does not fit.
void check_map(const std::vector<Subject>& subjects, const StudySettings& settings) {
  const parameters::ShadowSettings& shadows = settings.frame.shadows;
  const parameters::AtlasLayout atlas = parameters::atlas_layout(shadows.resolution, shadows.cascades);
  for (const Subject& subject : subjects)
    if (subject.light == techniques::LightKind::directional)
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
               timing_repeats, split_error, pictures, pan_frames, edge_samples, window, debug_views, answered,
               bake, jobs, compiler, cache] = settings;
  const auto add = [&](const auto&... values) { (platform::add_all(hash, values), ...); };
  add(reference_samples, seed, noise_seeds, timing_repeats, split_error, pictures, pan_frames, edge_samples,
      window);
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
    check_lights(settings.scenes, subjects, settings);
    check_map(subjects, settings);
    prepare(subjects);
  }

  StudyOutcome run() {
    for (const scene::Scene& given : settings_.scenes) {
      scene::Scene scene = given;
      scene::Rasteriser rasteriser(device_, scene);
      for (const double degrees : settings_.light_degrees) {
        if (scene.spot_light) scene.spot_light->source_radius_metres = source_radius_metres(degrees);
        const CaseSetup setup = cases_.build(scene, rasteriser, degrees);
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
      outcome_.records.back().shimmer = prepared.shimmer(setup, view.pan);
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
    if (!device_.info().is_software) options.warm_up_seconds = kWarmUpSeconds;
    Answer answer = prepared.answer(view.on_device_frame, options);
    if (averaged) answer.visibility = {mean_image(answer.visibility)};
    if (subject.history < 1.0 && answer.visibility.size() > 1)
      answer.visibility = histories(answer.visibility, subject.history, settings_.noise_seeds);
    outcome_.records.push_back(record_of(setup, view, subject, answer, settings_.window,
                                         prepared.unlimited_answer(setup, view, cache_),
                                         device_.info().name));
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
  StudyOutcome outcome_;
};

}  // namespace

techniques::LightKind light_kind(const std::vector<scene::Scene>& scenes) {
  for (const scene::Scene& scene : scenes) {
    if (kind_of(scene) == kind_of(scenes.front())) continue;
    throw InputError("", light_of(scenes.front()) + ", and " + light_of(scene),
                     "measure the two kinds of light in two runs");
  }
  return scenes.empty() ? techniques::LightKind::directional : kind_of(scenes.front());
}

StudyOutcome run_study(gpu::Device& device, const std::vector<Subject>& subjects,
                       const StudySettings& settings, const StudyProgress& progress) {
  return Study(device, subjects, settings, progress).run();
}

}  // namespace penumbra::study
