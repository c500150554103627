// The angle of elevation up to which ground hides the sky, for eight directions of the compass: whether
// ground shadows a point is then a comparison with the sun's own elevation, wherever the sun stands.
//
// Source: Max, "Horizon mapping: shadows for bump-mapped surfaces", The Visual Computer 4 (1988); Candycat,
// "Graphics Study: RDR2, shadows" (2021), for eight directions in two textures of four channels over a map of
// 12.5 km. Units: radians in [0, pi/2]; ground below the horizontal counts as 0. Assumes that shadow is
// monotone in the sun's elevation: true of a height field, where overhangs are solid down to the ground.
#pragma once

#include <array>
#include <vector>

#include "bake/block_run.h"
#include "bake/height_field.h"

namespace penumbra::bake {

inline constexpr int horizon_directions = 8;

// The direction towards the sky, x and z: number 0 is +Z, number 2 is +X, in steps of 45 degrees.
glm::dvec2 horizon_direction(int number);

struct HorizonAngles {
  int width = 0;  // texels along x; their centres are those of width equal parts of the area
  int depth = 0;
  Area area;
  std::array<std::vector<float>, horizon_directions> radians;  // width * depth each, rows as of HeightField

  glm::dvec2 centre(int x, int z) const;
};

struct HorizonOptions {
  int width = 512;
  int depth = 512;
  // Ground nearer than this does not count: cascades or contact shadows draw its shadows, or a texel's own
  // size cannot resolve it.
  double nearest_metres = 0.0;
};

inline constexpr int most_horizon_texels_per_side = 8192;

// Throws InputError for an unusable field or options; as run_bake.
HorizonAngles bake_horizon_angles(const HeightField& field, const HorizonOptions& options,
                                  const BakeOptions& run = {});

}  // namespace penumbra::bake
