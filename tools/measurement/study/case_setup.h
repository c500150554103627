// A case of a study, a scene under a light, before its subjects run. Internal to this folder.
#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "parameters/cascades.h"
#include "reference/reference_cache.h"
#include "reference/row_blocks.h"
#include "reference/visibility_image.h"
#include "resolve/camera_image.h"
#include "resolve/frame_inputs.h"
#include "resolve/frame_on_device.h"
#include "scene/frame.h"
#include "scene/scene.h"
#include "study/study.h"

namespace penumbra::study {

// A frame on the device, and as the camera's depth image where a subject runs over the screen.
struct FrameOfCase {
  resolve::FrameOnDevice on_device;
  std::optional<resolve::CameraImage> camera;
};

// The settings of a subject's frame: the casters' biases, the light and the cascades.
struct FrameRequest {
  parameters::CasterBias bias;
  scene::RasterBias raster_bias = scene::kUnityRasterBias;
  double light_scale = 1.0;
  scene::CascadeChoices cascade_choices{};

  static FrameRequest of(const Subject& subject) {
    return {subject.bias, subject.raster_bias, subject.light_scale, subject.cascade_choices};
  }
  bool operator==(const FrameRequest&) const = default;
};

// A case as all subjects of the same request see it.
struct View {
  FrameRequest request;
  scene::Frame frame;
  FrameOfCase on_device_frame;
  std::vector<FrameOfCase> earlier;  // StudySettings::frames but the last, where a subject has history
  std::vector<FrameOfCase> pan;
  std::optional<reference::VisibilityImage> t2;
  std::string key;  // a hash of the scene, the light, the frame and how its needs are baked
};

// The data of one scene under one light that are known before the first subject runs. All views share the
// receivers and therefore T1.
struct CaseSetup {
  const scene::Scene& scene;
  std::unique_ptr<const resolve::CastersOnDevice> casters;  // the scene's, where a subject draws them
  std::unique_ptr<const resolve::FrameInputs> inputs;       // the scene's, for the needs of all subjects
  double light_degrees = 0.0;
  reference::VisibilityImage t1;
  std::vector<View> views;  // one for each request of the subjects
  int width = 0;            // size of the picture
  int height = 0;
  int edge_samples = 0;  // as in StudySettings

  std::string label() const;  // "trees at 0.53 degrees"
  const View& view(const FrameRequest& request) const {
    return *std::find_if(views.begin(), views.end(),
                         [&](const View& view) { return view.request == request; });
  }
};

// Draws the scene for each request, and ray traces the reference.
class CaseBuilder {
 public:
  // The settings, the progress and the cache must outlive it.
  CaseBuilder(const gpu::Device& device, const std::vector<Subject>& subjects, const StudySettings& settings,
              const StudyProgress& progress, const reference::ReferenceCache& cache);

  CaseSetup build(const scene::Scene& scene, scene::Rasteriser& rasteriser, double degrees) const;

 private:
  void enlarge(CaseSetup& setup, scene::Rasteriser& rasteriser) const;
  std::unique_ptr<const resolve::CastersOnDevice> casters_of(const scene::Scene& scene) const;
  reference::VisibilityImage traced(const CaseSetup& setup, const scene::Receivers& receivers, int samples,
                                    const std::string& work) const;
  reference::VisibilityImage traced_edges(const CaseSetup& setup, scene::Rasteriser& rasteriser) const;
  scene::FrameSettings frame_settings(const CaseSetup& setup, const FrameRequest& request) const;
  void add_view(CaseSetup& setup, scene::Rasteriser& rasteriser, const FrameRequest& request) const;
  FrameOfCase on_device_frame(const CaseSetup& setup, const scene::Frame& frame) const;
  resolve::FrameInputs inputs_of(const CaseSetup& setup) const;
  FrameOfCase moved_frame(const CaseSetup& setup, const scene::FrameSettings& settings, double pixels,
                          scene::Rasteriser& rasteriser) const;
  std::vector<FrameOfCase> earlier_frames(const CaseSetup& setup, const scene::FrameSettings& settings,
                                          scene::Rasteriser& rasteriser) const;
  std::vector<FrameOfCase> pan_frames(const CaseSetup& setup, const scene::FrameSettings& settings,
                                      scene::Rasteriser& rasteriser) const;
  reference::VisibilityImage same_map_estimate(const CaseSetup& setup, scene::Rasteriser& rasteriser,
                                               const View& view) const;
  reference::RunOptions run_options(const std::string& work, const std::string& unit) const;

  const gpu::Device& device_;
  const std::vector<Subject>& subjects_;
  const StudySettings& settings_;
  const StudyProgress& progress_;
  const reference::ReferenceCache& cache_;
  platform::CacheStore bakes_;  // finished rows of bakes, which the next run reads
};

// Counts the pixels that are neither lit nor dark.
std::size_t penumbra_pixels(const reference::VisibilityImage& image);

// The reference at edges of a multisampled picture: the mean of the visibility at a pixel's samples.
//
// A pixel counts if its samples see several surfaces: two of them face different ways, or lie apart. Pixels
// one of whose samples sees no receiver do not count: the sky beside them has no shadow to compare. Internal
// to this folder.

// Returns the places of a pixel's samples, from its centre, in pixels to the right and down: the standard
// patterns of Direct3D and Vulkan. `samples` is 2, 4 or 8; throws std::invalid_argument for others.
std::vector<glm::dvec2> sample_offsets(int samples);

// The receivers that all pixels' samples of one number see, and their reference.
struct SampleView {
  scene::Receivers receivers;
  reference::VisibilityImage traced;
};

// `samples` are of equal size, at least 2. The result's visibility is the mean; it is valid at edges alone.
reference::VisibilityImage edge_reference(std::span<const SampleView> samples,
                                          const parameters::Camera& camera);

}  // namespace penumbra::study
