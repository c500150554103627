// The location of the files that the program reads at run time: ShaderLibrary/ and the program's own shaders.
#pragma once

#include <filesystem>

namespace penumbra::platform {

// The first of these that holds ShaderLibrary/Shadows.hlsl: $PENUMBRA_ROOT, share/penumbra beside the
// program's folder, the source tree the program was built from. Throws EnvironmentError naming all three.
std::filesystem::path data_directory();

}  // namespace penumbra::platform
