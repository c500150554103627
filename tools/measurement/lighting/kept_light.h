// sky_light(), cached on disk under the hash of its inputs.
#pragma once

#include <filesystem>

#include "lighting/sky_light.h"

namespace penumbra::lighting {

// An empty `folder` means the folder of reference::ReferenceCache. Throws as sky_light() does, and InputError
// when the folder cannot be written.
std::vector<glm::vec3> kept_sky_light(const scene::Scene& scene, const SeenMaterials& seen,
                                      const Surroundings& surroundings, int rays,
                                      const std::filesystem::path& folder, const reference::RunOptions& run);

}  // namespace penumbra::lighting
