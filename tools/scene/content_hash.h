// A name for a scene's content: equal pictures have equal names (platform/content_hash.h).
#pragma once

#include <string>

namespace penumbra::scene {

struct Scene;

// Of all that decides the picture: mesh, origin, camera, light direction, shadow distance; not the name or
// the description.
std::string content_hash(const Scene& scene);

}  // namespace penumbra::scene
