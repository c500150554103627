#include "study/lit_difference.h"

namespace penumbra::study {
namespace {

// A pixel of the lit picture is a pixel of the frame that is measured.
lighting::LitSettings lit_settings(double light_degrees, const StudySettings& settings) {
  lighting::LitSettings lit;
  lit.supersampling = 1;
  lit.light_degrees = light_degrees;
  lit.jobs = settings.jobs;
  lit.cache = settings.cache;
  return lit;
}

FlipReference flip_reference(const lighting::LitFrame& frame, std::span<const float> visibility) {
  const std::vector<glm::vec3> colours = frame.picture(visibility);
  return FlipReference({frame.width(), frame.height(), colours});
}

}  // namespace

LitDifference::LitDifference(const scene::Scene& scene, const scene::Frame& frame,
                             std::span<const float> reference, double light_degrees,
                             const StudySettings& settings, const StudyProgress& progress)
    : frame_(scene, frame, lit_settings(light_degrees, settings), progress),
      reference_(flip_reference(frame_, reference)) {}

double LitDifference::of(std::span<const float> visibility) const {
  const std::vector<glm::vec3> colours = frame_.picture(visibility);
  return reference_.mean_difference({frame_.width(), frame_.height(), colours});
}

}  // namespace penumbra::study
