// The part of the world that each cascade's tile shows, before it is placed in the map. Internal to this
// folder.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "parameters/cascades.h"
#include "parameters/light_axes.h"

namespace penumbra::parameters {

// In world space, metres.
struct SplitSphere {
  glm::dvec3 centre;
  double radius = 0.0;
};

// In light space, metres: a square of side 2 * half_extent, and a depth interval.
struct TileBox {
  glm::dvec2 centre;
  double half_extent = 0.0;
  double near_depth = 0.0;
  double far_depth = 0.0;
  double margin_texels = kSnapMarginTexels;  // on each side, of the map
};

struct SplitTile {
  SplitSphere sphere;
  TileBox box;
  LightAxes axes;  // in which the box is given
};

// By the split spheres, and caster_bounds where the settings fit to them. Throws InputError when a setting is
// out of range.
std::vector<SplitTile> split_tiles(const Camera& camera, const Light& light, const ShadowSettings& settings);

// The tiles, snapped to whole texels with their margins, their matrices and scales. Throws InputError when a
// float cannot represent them.
CascadeSet placed(const std::vector<SplitTile>& tiles, const Light& light, const ShadowSettings& settings);

}  // namespace penumbra::parameters
