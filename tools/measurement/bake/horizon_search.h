// The elevation of a height field's horizon, seen from a point in one direction. It is exact for the bilinear
// surface.
//
// Along a line over one cell the surface's height is a quadratic polynomial of the distance, so the steepest
// slope to it is found in closed form. A pyramid of largest heights serves to skip blocks of 2^n x 2^n cells
// that cannot be steeper than the slope already found: Tevs, Ihrke, Seidel, "Maximum mipmaps for fast,
// accurate, and scalable dynamic height field rendering", I3D 2008.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "bake/height_field.h"

namespace penumbra::bake {

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
