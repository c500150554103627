// The location of the files that the program reads at run time: ShaderLibrary/ and the program's own shaders.
#pragma once

#include <filesystem>

namespace penumbra::platform {

// Returns the first of these that holds ShaderLibrary/Shadows.hlsl: $PENUMBRA_ROOT, share/penumbra beside the
// program's folder, the source tree from which the program was built. Throws EnvironmentError naming all
// three.
std::filesystem::path data_directory();

}  // namespace penumbra::platform
