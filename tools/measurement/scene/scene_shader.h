// The rasteriser's own shaders, compiled from tools/measurement/scene/shaders below the data directory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shaders/compile.h"

namespace penumbra::scene {

struct SceneShader {
  std::string file;
  std::string entry;
  hlsl::Stage stage;
  bool reversed_z;
  bool cut_outs = false;    // of a scene that has some
  bool spot_light = false;  // of one that is lit by one
};

// Throws EnvironmentError with the compiler's messages: these files are ours, not the user's.
std::vector<std::uint32_t> compile_scene_shader(const SceneShader& shader);

}  // namespace penumbra::scene
