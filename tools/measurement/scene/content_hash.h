// A content hash of a scene (platform/content_hash.h).
#pragma once

#include <string>

namespace penumbra::scene {

struct Scene;

// The hash covers everything that affects shadows and the receivers: the mesh's geometry and cut-outs,
// origin, camera, light, shadow distance. It does not cover the name or the description, nor the rest of
// materials and textures: a reference remains valid if colours change. Throws InputError as CutOuts does.
std::string content_hash(const Scene& scene);

}  // namespace penumbra::scene
