// The rasteriser's own shaders, compiled from tools/scene/shaders below the data directory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shaders/compile.h"

namespace penumbra::scene {

// Throws EnvironmentError with the compiler's messages: these files are ours, not the user's.
std::vector<std::uint32_t> compile_scene_shader(const std::string& file, const std::string& entry,
                                                hlsl::Stage stage, bool reversed_z);

}  // namespace penumbra::scene
