// The surface that the camera sees at each pixel, ready for lighting: position, orientation, material.
//
// The point is where the ray through the pixel's centre meets the plane of the pixel's triangle, in double;
// vertex normals, texture coordinates and the normal map are read there, textures through the pixel's
// footprint. Space: relative to the scene's origin, metres, tangents as glTF has them.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "reference/row_blocks.h"
#include "scene/frame.h"
#include "scene/scene.h"

namespace penumbra::lighting {

struct SurfacePoint {
  glm::vec3 position{0.0F};
  glm::vec3 flat_normal{0.0F};  // the triangle's normal, turned to the camera
  glm::vec3 normal{0.0F};       // interpolated, and bent by the normal map, on the same side
  glm::vec3 base_colour{0.0F};  // linear, each in [0, 1]
  float roughness = 1.0F;
  float translucency = 0.0F;
};

struct SeenMaterials {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> seen;         // 0: the sky
  std::vector<SurfacePoint> points;       // meaningful where `seen` is not 0
  std::vector<glm::vec3> view_direction;  // unit, from the camera through the pixel's centre
};

// Throws InputError for a scene without materials, with texture coordinates or materials of another number
// than its vertices or triangles, or an index out of range, and for a frame without triangles per pixel.
SeenMaterials seen_materials(const scene::Scene& scene, const scene::Frame& frame);

// Returns one colour for each material, for uses that need only a mean: the material's own colour times the
// mean of its texture.
std::vector<glm::vec3> mean_colours(const scene::Scene& scene);

}  // namespace penumbra::lighting
