// The light that a surface has from everything but the sun's own rays: sky, and what the scene reflects of
// sky and sun.
//
// Rays of cosine-weighted directions around the shading normal (Embree 3) sample it, along a golden spiral
// turned anew at each pixel. A ray that meets nothing brings the sky's radiance. A ray that meets a surface
// brings the light which that surface reflects or lets through: the sun's, by one shadow ray towards the
// middle of its disc, and the sky's, as if half of it were hidden there. Directions below the flat surface
// are mirrored above it; a translucent surface sends its share of the rays out behind. Units: radiance of a
// white matt surface under that light, so that times the colour it is what the camera sees; under an unhidden
// sky of radiance L it is L. Results are deterministic, finite and never negative.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "lighting/seen_materials.h"
#include "lighting/sky_dome.h"
#include "reference/row_blocks.h"
#include "scene/scene.h"

namespace penumbra::lighting {

struct Surroundings {
  const SkyDome& sky;
  glm::vec3 to_sun;  // unit
  glm::vec3 sun;     // irradiance of a surface that faces it
};

// `rays` is the number per pixel, rounded up to a multiple of 16.
std::vector<glm::vec3> sky_light(const scene::Scene& scene, const SeenMaterials& seen,
                                 const Surroundings& surroundings, int rays,
                                 const reference::RunOptions& run = {});

}  // namespace penumbra::lighting
