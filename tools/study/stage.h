// One scene under one light, set for subjects to be asked. Internal to this room.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reference/reference_cache.h"
#include "reference/row_blocks.h"
#include "reference/visibility_image.h"
#include "resolve/camera_image.h"
#include "resolve/frame_on_device.h"
#include "scene/frame.h"
#include "scene/scene.h"
#include "study/study.h"

namespace penumbra::study {

// A frame on the device, and as the camera's depth image for passes over the screen.
struct StagedFrame {
  resolve::FrameOnDevice on_device;
  resolve::CameraImage camera;
};

// What a subject asks of the frame that it is shown.
struct Wishes {
  parameters::CasterBias bias;
  double light_scale = 1.0;

  static Wishes of(const Subject& subject) { return {subject.bias, subject.light_scale}; }
  bool operator==(const Wishes&) const = default;
};

// A scene under a light as all subjects of the same wishes see it.
struct View {
  Wishes wishes;
  scene::Frame frame;
  StagedFrame staged;
  std::vector<StagedFrame> pan;
  std::optional<reference::VisibilityImage> t2;
  std::string key;  // of scene, light, map and receivers
};

// Everything known about one scene under one light before the first subject is asked. Receivers, and with
// them T1, are those of every view.
struct Stage {
  const scene::Scene& scene;
  double light_degrees = 0.0;
  reference::VisibilityImage t1;
  std::vector<View> views;  // by the wishes of subjects, each once
  int width = 0;            // of the picture
  int height = 0;

  std::string label() const;  // "trees at 0.53 degrees"
  const View& view(const Wishes& wishes) const {
    return *std::find_if(views.begin(), views.end(), [&](const View& view) { return view.wishes == wishes; });
  }
};

// Sets stages: draws the scene for every wish, and ray traces what all are held against.
class StageSetter {
 public:
  // The settings, the progress and the cache have to outlive it.
  StageSetter(const gpu::Device& device, const std::vector<Subject>& subjects, const StudySettings& settings,
              const StudyProgress& progress, const reference::ReferenceCache& cache);

  Stage set(const scene::Scene& scene, scene::Rasteriser& rasteriser, double degrees) const;

 private:
  void enlarge(Stage& stage, scene::Rasteriser& rasteriser) const;
  scene::FrameSettings frame_settings(const Stage& stage, const Wishes& wishes) const;
  void add_view(Stage& stage, scene::Rasteriser& rasteriser, const Wishes& wishes) const;
  StagedFrame staged(const scene::Frame& frame) const;
  std::vector<StagedFrame> pan_frames(const scene::FrameSettings& settings,
                                      scene::Rasteriser& rasteriser) const;
  reference::VisibilityImage same_map_estimate(const Stage& stage, scene::Rasteriser& rasteriser,
                                               const View& view) const;
  reference::RunOptions run_options(const std::string& work, const std::string& unit) const;

  const gpu::Device& device_;
  const std::vector<Subject>& subjects_;
  const StudySettings& settings_;
  const StudyProgress& progress_;
  const reference::ReferenceCache& cache_;
};

// Pixels that are neither lit nor dark.
std::size_t penumbra_pixels(const reference::VisibilityImage& image);

}  // namespace penumbra::study
