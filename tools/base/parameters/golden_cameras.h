// Cameras for golden vectors: the awkward ones first, then random ones. All matrices hold floats exactly.
#pragma once

#include <string>
#include <vector>

#include "parameters/random_setup.h"
#include "parameters/screen_to_world.h"

namespace penumbra::parameters {

struct GoldenCamera {
  std::string name;
  glm::dmat4 view{1.0};
  glm::dmat4 gpu_projection{1.0};
  ScreenConventions conventions;
};

// Returns cameras that are off-centre, oblique, orthographic, reversed, flipped or far from the origin, with
// near planes close to 0 and far planes at infinity; then `random` cameras of every kind mixed.
std::vector<GoldenCamera> golden_cameras(int random, SetupGenerator& generator);

}  // namespace penumbra::parameters
