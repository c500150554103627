// A study: subjects (techniques, users' own functions) over scenes and lights, each measured against ray
// tracing on the same frame.
//
// Per scene and light: the frame is rasterised once per bias and diameter that subjects ask for; T1 is
// ray-traced once, T2 estimated once per bias, both cached on disk; every subject is resolved for each noise
// seed, counted and timed; T3 is the subject with unlimited samples, cached on disk, too. Nothing here
// prints.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/device.h"
#include "reference/visibility_image.h"
#include "resolve/compiled_graph.h"
#include "scene/frame.h"
#include "scene/scene.h"
#include "study/baked_inputs.h"
#include "study/picture.h"
#include "study/report.h"
#include "study/results.h"
#include "techniques/technique_list.h"

namespace penumbra::study {

struct Subject {
  std::string name;
  std::string title;
  std::map<std::string, std::vector<double>> parameters;
  std::vector<techniques::CascadeRule> cascades{};  // the technique's
  resolve::ShadowGraph graph;
  parameters::CasterBias bias{};  // the bias with which its casters are drawn
  scene::RasterBias raster_bias = scene::kUnityRasterBias;
  double light_scale = 1.0;  // the diameter that it is given, divided by the light's
  scene::CascadeChoices cascade_choices{};
  std::optional<resolve::ShadowGraph> unlimited{};  // absent: the subject takes no samples and is its own T3
  // The number of frames with different noise whose mean is the subject's result: the limit of temporal
  // antialiasing in a static scene. With 1, every noise seed is a separate result.
  int averaged_frames = 1;
  // The share of the newest of the frames with different noise whose exponential mean is the subject's result
  // (histories()); not with averaged_frames. With 1, each frame stands alone.
  double history = 1.0;
};

// Throws InputError for a technique that is not for the sun.
Subject technique_subject(const techniques::TechniqueList& list, const techniques::Technique& technique,
                          bool reversed_z);
Subject adapter_subject(const resolve::Adapter& adapter, bool reversed_z);

// The result of one subject in one frame. It is valid during the callback.
struct SubjectAnswer {
  const scene::Scene& scene;
  const scene::Frame& frame;
  const reference::VisibilityImage& reference;
  const Record& record;
  std::span<const float> visibility;  // that of the first noise seed, or the mean over averaged frames
};

struct StudySettings {
  std::vector<scene::Scene> scenes;
  std::vector<double> light_degrees;  // the sun's angular diameters
  // The light, the shadow distance and both biases of the casters are set per scene, light and subject.
  scene::FrameSettings frame;
  // The minimum number of penumbra pixels in T1 of each scene and light. The picture grows from frame.width x
  // frame.height, by steps that about double its area, up to sixteen times each way and 3840 x 2160, until it
  // has as many. With 0 the picture's size is fixed.
  int penumbra_pixels = 0;
  int reference_samples = 1024;
  std::uint64_t seed = 1;
  int noise_seeds = 16;
  int timing_repeats = 5;
  bool split_error = true;  // measures T2 and T3
  bool overlaps = false;    // measures the error where shadows of low and high casters overlap
  bool flip = false;        // measures FLIP of the lit picture; scenes need materials that can be lit
  bool pictures = true;     // if false, the outcome's are empty
  int pan_frames = 0;       // frames of a slow pan, for shimmer; none if below 2
  // Of techniques with history: the frames that are drawn, the last of which is measured, and how far the
  // picture moves from one to the next, pixels to the left; 0 at rest.
  int frames = 16;
  double frame_step = 0.5;
  // With 2, 4 or 8, only pixels whose so many samples see several surfaces count, against the mean of the
  // samples (edge_reference()); without split_error. With 0 every pixel counts, at its centre.
  int edge_samples = 0;
  // The part of the picture that is measured; shimmer, and the pictures, cover all of it. Absent means all.
  std::optional<PictureWindow> window;
  // The passes of PenumbraDebugViews.shader that are drawn of every subject that runs over the screen.
  std::vector<std::string> debug_views{};
  // It is called with every answer, in the order of the outcome's records; may be empty.
  std::function<void(const SubjectAnswer&)> answered{};
  BakeSettings bake{};  // settings of the inputs that subjects need besides the frame
  int jobs = 0;
  resolve::Compiler compiler{};
  std::filesystem::path cache;  // empty: the user's cache folder
};

// `stage` names the work in progress; `done` and `total` count the stage's `unit`s.
using StudyProgress =
    std::function<void(std::string_view stage, double done, double total, std::string_view unit)>;

class KeptRecords;

struct StudyOutcome {
  std::vector<MeasuredFrame> frames;  // one for every scene and light
  std::vector<Record> records;
  std::vector<PictureRow> pictures;  // one for every record
  std::vector<std::string>
      notes;  // uniforms that are not provided, pictures with too little penumbra, and similar
  // All records, as the next run of the study finds them. They are dropped when they have been written
  // elsewhere.
  std::shared_ptr<KeptRecords> kept;
};

// Throws InputError for shaders that do not compile, and platform::Interrupted if the user interrupts.
// Finished results are kept in either case, until StudyOutcome::kept is dropped.
StudyOutcome run_study(gpu::Device& device, const std::vector<Subject>& subjects,
                       const StudySettings& settings, const StudyProgress& progress);

// Temporal antialiasing of a technique's noise while nothing moves: each pixel's exponential mean over the
// frames.
//
//   history = (1 - share) history + share frame
//
// This is Karis, "High-Quality Temporal Supersampling", SIGGRAPH 2014, without its clamp to the colours of
// neighbours, which cuts the same noise off in every technique.

// Returns the number of frames that `results` results need. The first result comes when less than a hundredth
// of the mean is the first frame's. Each other one comes seven frames later, which meets every phase of noise
// that repeats after a power of two frames. `share` is that of the newest frame, above 0, up to 1.
int history_frames(double share, int results);

// Returns one image per result, from as many frames as history_frames() says.
std::vector<std::vector<float>> histories(const std::vector<std::vector<float>>& frames, double share,
                                          int results);

}  // namespace penumbra::study
