// The part of the world that each cascade's tile shows, before it is placed in the map. Internal to this
// folder.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "parameters/cascades.h"
#include "parameters/light_axes.h"

namespace penumbra::parameters {

// The sphere is in world space, in metres.
struct SplitSphere {
  glm::dvec3 centre;
  double radius = 0.0;
};

// The box is in light space, in metres: a square of side 2 * half_extent, and a depth interval.
struct TileBox {
  glm::dvec2 centre;
  double half_extent = 0.0;
  double near_depth = 0.0;
  double far_depth = 0.0;
  double margin_texels = kSnapMarginTexels;  // texels of the map on each side
};

struct SplitTile {
  SplitSphere sphere;
  TileBox box;
  LightAxes axes;  // the space of the box
};

// Returns the tiles of the split spheres, limited by caster_bounds where the settings fit to them. Throws
// InputError when a setting is out of range.
std::vector<SplitTile> split_tiles(const Camera& camera, const Light& light, const ShadowSettings& settings);

// Returns the tiles, snapped to whole texels with their margins, with their matrices and scales. Throws
// InputError when a float cannot represent them.
CascadeSet placed(const std::vector<SplitTile>& tiles, const Light& light, const ShadowSettings& settings);

}  // namespace penumbra::parameters
