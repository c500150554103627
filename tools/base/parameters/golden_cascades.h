// Cascades for golden vectors: the awkward ones first, then random ones. All inputs hold floats exactly.
#pragma once

#include <string>
#include <vector>

#include "parameters/golden_settings.h"

namespace penumbra::parameters {

// A cascade as a renderer meets it: a matrix of floats, the map it leads to, and settings.
struct GoldenCascade {
  std::string name;
  glm::dmat4 world_to_shadow{1.0};
  int resolution = 2048;
  int cascades = 4;
  SoftShadowParameters parameters;
  double depth_bias = 1.0;
  double normal_bias = 1.0;
  SoftQuality quality = SoftQuality::medium;
};

// Returns cascades with scales of every size a float has, no angle and the widest, sheared, far away; then
// `random` fits.
std::vector<GoldenCascade> golden_cascades(int random, SetupGenerator& generator);

}  // namespace penumbra::parameters
