// What simple shadow techniques are told of a scene in place of its mesh: one plane that receives, and balls
// that cast.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace penumbra::scene {

// Height of the ground, metres, relative to the scene's origin: that of the most level area that faces up,
// heights within a millimetre taken together; of a mesh without any, the height of its lowest vertex.
double ground_level(const Mesh& mesh);

struct Ball {
  glm::dvec3 centre{0.0};
  double radius = 0.0;  // metres
};

// The objects of a mesh as balls, the largest first, at most so many. An object is a part whose triangles
// meet at vertices of one position, without those that lie in the ground; a part longer than half the mesh
// is ground or a wall, and none. Its ball has the centre of its surface, and a quarter of the surface as its
// disc: as much is the mean shadow of a convex body over all directions (Cauchy 1850).
std::vector<Ball> object_balls(const Mesh& mesh, std::size_t most);

}  // namespace penumbra::scene
