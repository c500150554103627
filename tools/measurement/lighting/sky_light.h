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
#include <filesystem>
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

// An empty `folder` means the folder of reference::ReferenceCache. Throws as sky_light() does, and InputError
// when the folder cannot be written.
std::vector<glm::vec3> kept_sky_light(const scene::Scene& scene, const SeenMaterials& seen,
                                      const Surroundings& surroundings, int rays,
                                      const std::filesystem::path& folder, const reference::RunOptions& run);

// A filter that removes the noise of light gathered by few rays without blurring across edges.
//
// Source: H. Dammertz et al., "Edge-Avoiding A-Trous Wavelet Transform for fast Global Illumination
// Filtering" (HPG 2010). Passes of a 5 x 5 B3 spline, whose taps stand twice as far apart each time, are
// weighted by how alike the neighbour's normal is and how near it lies to the pixel's plane. The neighbour's
// colour does not enter the weight, so the filter is linear in the light and adds no bias where the light is
// constant. Guarantees: each result is a weighted mean of the pixels around; pixels that show the sky are
// neither sources nor results. Deterministic.
std::vector<glm::vec3> smoothed(const SeenMaterials& seen, std::vector<glm::vec3> light, int passes,
                                const reference::RunOptions& run = {});

}  // namespace penumbra::lighting
