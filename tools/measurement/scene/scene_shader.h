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
  bool cut_outs = false;    // the scene has cut-outs
  bool spot_light = false;  // the light is a spot light
};

// Throws EnvironmentError with the compiler's messages, because these files are ours and not the user's.
std::vector<std::uint32_t> compile_scene_shader(const SceneShader& shader);

}  // namespace penumbra::scene
