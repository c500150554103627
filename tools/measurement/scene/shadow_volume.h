// The closed mesh around all that a mesh shades from a light in one direction: Crow, "Shadow algorithms for
// computer graphics", SIGGRAPH 1977. A stencil buffer counts how often a point lies in it (Heidmann, "Real
// shadows, real time", Iris Universe 18, 1991), from behind, so that the camera may be inside of it (Carmack
// 2000, in Everitt and Kilgard, "Practical and robust stenciled shadow volumes", NVIDIA 2002).
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/scene.h"

namespace penumbra::scene {

// A cap of the triangles that cast, the same cap moved along the light, and walls between their boundaries.
// For a point beside the mesh's surfaces, the number of times that it lies inside is the number of casting
// triangles between it and the light.
struct ShadowVolume {
  // The vertices of the caps that lie on the mesh, each position once and bit for bit the mesh's (but -0 is
  // 0); then the same number of vertices moved along the light.
  std::vector<glm::vec3> positions;
  // There are three for each triangle, wound so that cross(b - a, c - a) points out of the volume. Each
  // directed edge occurs as often as its opposite: the volume is closed.
  std::vector<std::uint32_t> indices;
  std::size_t caps = 0;           // triangles of one cap
  std::size_t walls = 0;          // walls, of two triangles each
  std::size_t closed_pieces = 0;  // pieces of the mesh that are closed, and others
  std::size_t open_pieces = 0;
};

// `triangles`: three indices into `positions` each. `way`: from a vertex to its place in the other cap, along
// the way the light travels, in the unit of the positions.
//
// Vertices at one position are one vertex; a triangle with two corners at one position is left out. Triangles
// that share an edge belong to one piece. A piece is closed where every edge is passed as often in one
// direction as in the other, however many triangles meet there. Of a closed piece the triangles cast whose
// normal, cross(b - a, c - a), points along the light: lit surfaces then never coincide with a cap. It is
// taken for a solid that is seen from outside of its winding. Of any other piece, such as a leaf, or one with
// T-junctions, every triangle casts. A triangle along which the light passes exactly casts nothing.
//
// Walls stand where the directed edges of a cap do not cancel, one for each that remains. So the volume is
// closed whatever the mesh is, also where rounding decides which side of a triangle the light meets.
//
// Throws InputError for an index outside of the positions or a number that is no multiple of three, a
// position that is used and not finite, a way that is zero or not finite, and where a moved vertex exceeds
// the range of a float.
ShadowVolume shadow_volume(const std::vector<glm::vec3>& positions,
                           const std::vector<std::uint32_t>& triangles, const glm::dvec3& way);

// Makes the volume of all of a scene's triangles but those that blend, which shadow maps do not hold either;
// cut-out ones cast as if they had no holes. It ends beyond the scene's bounds. Throws InputError as
// above.
ShadowVolume shadow_volume(const Scene& scene);

}  // namespace penumbra::scene
