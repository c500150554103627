// A name for a scene's content: equal pictures have equal names (platform/content_hash.h).
#pragma once

#include <string>

namespace penumbra::scene {

struct Scene;

// Of all that decides where shadows fall and what is seen of them: the mesh's geometry and cut-outs, origin,
// camera, light, shadow distance. Not of the name or the description, nor of the rest of materials
// and textures: the same reference holds for a scene painted anew. Throws InputError as CutOuts does.
std::string content_hash(const Scene& scene);

}  // namespace penumbra::scene
