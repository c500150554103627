// The shapes that stand for a scene's mesh in simple shadow techniques: one plane that receives, and balls
// that cast.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace penumbra::scene {

// Returns the height of the ground in metres, relative to the scene's origin: that of the most level area
// that faces up, heights within a millimetre taken together. For a mesh without such an area it is the height
// of the lowest vertex.
double ground_level(const Mesh& mesh);

struct Ball {
  glm::dvec3 centre{0.0};
  double radius = 0.0;  // metres
};

// Returns the objects of a mesh as balls, the largest first, at most so many. An object is a part whose
// triangles meet at vertices of one position, without those that lie in the ground; a part longer than half
// the mesh is ground or a wall, and no object. Its ball has the centre of its surface, and a quarter of the
// surface as its disc: that is the mean shadow of a convex body over all directions (Cauchy 1850).
std::vector<Ball> object_balls(const Mesh& mesh, std::size_t most);

}  // namespace penumbra::scene
