// The difference between pictures lit by a subject's visibility and by the ray-traced one, as FLIP sees it.
#pragma once

#include <span>

#include "lighting/lit_frame.h"
#include "scene/frame.h"
#include "scene/scene.h"
#include "study/flip.h"
#include "study/study.h"

namespace penumbra::study {

class LitDifference {
 public:
  // `reference` has the ray-traced visibility of each pixel of the frame. Throws what lighting::LitFrame
  // does.
  LitDifference(const scene::Scene& scene, const scene::Frame& frame, std::span<const float> reference,
                double light_degrees, const StudySettings& settings, const StudyProgress& progress);

  // Returns the mean over the picture, 0 to 1.
  double of(std::span<const float> visibility) const;

 private:
  lighting::LitFrame frame_;
  FlipReference reference_;
};

}  // namespace penumbra::study
