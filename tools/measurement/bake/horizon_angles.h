// The angle of elevation up to which ground hides the sky, for eight directions of the compass: whether
// ground shadows a point is then a comparison with the sun's own elevation, wherever the sun stands.
//
// Source: Max, "Horizon mapping: shadows for bump-mapped surfaces", The Visual Computer 4 (1988); Candycat,
// "Graphics Study: RDR2, shadows" (2021), for eight directions in two textures of four channels over a map of
// 12.5 km. Units: radians in [0, pi/2]; ground below the horizontal counts as 0. Assumes that shadow is
// monotone in the sun's elevation: true of a height field, where overhangs are solid down to the ground.
#pragma once

#include <glm/vec2.hpp>

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

// The elevation of a height field's horizon, seen from a point in one direction. It is exact for the bilinear
// surface.
//
// Along a line over one cell the surface's height is a quadratic polynomial of the distance, so the steepest
// slope to it is found in closed form. A pyramid of largest heights serves to skip blocks of 2^n x 2^n cells
// that cannot be steeper than the slope already found: Tevs, Ihrke, Seidel, "Maximum mipmaps for fast,
// accurate, and scalable dynamic height field rendering", I3D 2008.
class HorizonSearch {
 public:
  // The constructor keeps a reference to the field, which check_height_field() must accept.
  explicit HorizonSearch(const HeightField& field);

  // Returns the tangent of the horizon's angle of elevation: the largest (ground - height) / distance over
  // all points of the field in that direction, at a distance of nearest_metres or more. `from` is x and z in
  // metres and may lie outside of the field's area; `direction` is a unit vector of x and z. The result is
  // negative where all of the ground lies lower, and minus infinity where there is none. Reentrant.
  double steepest(glm::dvec2 from, double height, glm::dvec2 direction, double nearest_metres = 0.0) const;

 private:
  struct Level {
    int width = 0;
    int depth = 0;
    std::vector<float> highest;  // the largest height of each block of cells
  };

  const HeightField& field_;
  std::vector<Level> levels_;  // levels_[n] has blocks of 2^n cells each way
};

}  // namespace penumbra::bake
