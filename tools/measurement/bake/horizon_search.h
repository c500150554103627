// How high the ground of a height field stands before the sky, seen from a point in one direction: exact for
// the bilinear surface.
//
// Along a line over one cell the surface's height is a quadratic polynomial of the distance, so that the
// steepest slope to it is found in closed form. Cells that cannot be steeper than what was found are passed
// over in blocks of 2^n x 2^n, by a pyramid of the largest height in each: Tevs, Ihrke, Seidel, "Maximum
// mipmaps for fast, accurate, and scalable dynamic height field rendering", I3D 2008.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "bake/height_field.h"

namespace penumbra::bake {

class HorizonSearch {
 public:
  // Keeps a reference to the field, which check_height_field() must accept.
  explicit HorizonSearch(const HeightField& field);

  // The tangent of the angle of elevation of the horizon: the largest (ground - height) / distance over all
  // points of the field in that direction, at a distance of nearest_metres or more. `from`: x and z, metres,
  // which may lie outside of the field's area; direction: x and z, a unit vector. Negative where all of the
  // ground lies lower; minus infinity where there is none. Reentrant.
  double steepest(glm::dvec2 from, double height, glm::dvec2 direction, double nearest_metres = 0.0) const;

 private:
  struct Level {
    int width = 0;
    int depth = 0;
    std::vector<float> highest;  // of a block of cells
  };

  const HeightField& field_;
  std::vector<Level> levels_;  // of blocks of 2^index cells each way
};

}  // namespace penumbra::bake
