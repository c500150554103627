// The objects of a scene: triangles that hang together, without the ground.
//
// scene/stand_ins.h has another answer, for another purpose: there a part longer than half the scene is left
// out and small ones are dropped, because a ball in its place would be wrong; here no part may be left out,
// and positions are joined within rounding, because a field must be closed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace penumbra::bake {

struct SceneObject {
  std::vector<std::uint32_t> triangles;  // the object's triangles, in the order of the scene's mesh
  std::size_t parts =
      0;  // number of parts that do not touch one another: more than 1 where parts share an object
  parameters::Bounds box{};  // relative to the scene's origin
};

struct SceneObjects {
  std::vector<SceneObject> objects;  // those with the largest box first
  std::size_t parts = 0;             // number of parts of all objects
  std::size_t ground_triangles = 0;  // triangles of level sheets, which are no objects
  std::size_t flat_triangles = 0;    // triangles without area, which are left out
};

inline constexpr int most_field_objects = 16;

// Parts are connected by vertices at one position, or nearer than 2^-20 of the mesh's largest coordinate. A
// part is ground if it is level (no higher than a thousandth of its width) and covers a quarter of the
// scene's width or more, both ways. Where there are more parts than `most`, parts beside one another share an
// object: all begin in one, and the object with the largest box is cut in two, where both boxes are the
// smallest, until there are as many as asked for. So no part is left out. Throws InputError for `most`
// outside of 1 to most_field_objects, a mesh without triangles, with a vertex that is not a finite number or
// an index outside of the vertices, and for a scene that is ground alone.
SceneObjects objects_of(const scene::Scene& scene, int most);

// The object's triangles as a scene of their own, in the same space. Vertices at one position are one vertex;
// normals are not kept.
scene::Scene scene_of(const scene::Scene& scene, const SceneObject& object);

}  // namespace penumbra::bake
