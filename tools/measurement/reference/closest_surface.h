// The point of a mesh that is nearest to a place, and on which side of the mesh the place lies.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "reference/embree_scene.h"

namespace penumbra::reference {

// A point of a triangle: inside of it, on edge 0 to 2 (from that corner to the next), or at corner 0 to 2.
struct TrianglePoint {
  enum class Feature { face, edge, corner };

  glm::dvec3 point{0.0};
  Feature feature = Feature::face;
  int number = 0;  // number of the edge or the corner
};

// Returns the nearest point of a triangle; a triangle without area is the segment or the point that remains
// of it. Source: Ericson, "Real-Time Collision Detection" (2005), 5.1.5.
TrianglePoint nearest_on_triangle(const glm::dvec3& place, const std::array<glm::dvec3, 3>& corners);

class ClosestSurface {
 public:
  // The constructor keeps references to both; `rays` must be made of that scene, which has triangles.
  // Vertices at one position count as one vertex.
  ClosestSurface(const EmbreeScene& rays, const scene::Scene& scene);

  // Counts the edges that do not have two triangles which pass them in opposite directions. A closed mesh
  // whose triangles all turn the same way has none.
  std::size_t open_edges() const { return open_edges_; }

  // Returns the metres to the nearest point, negative inside: where the nearest point's angle-weighted normal
  // points away from the place. The sign is exact for closed meshes (Baerentzen and Aanaes, "Signed distance
  // computation using the angle weighted pseudonormal", 2005). For other meshes, and for those that pass
  // through themselves, it is the side of the nearest triangles. A closed mesh that is turned inside out
  // gives the same result. Reentrant.
  double distance(const glm::dvec3& place) const;

 private:
  std::array<glm::dvec3, 3> corners(std::size_t triangle) const;
  glm::dvec3 normal_at(std::size_t triangle, const TrianglePoint& nearest) const;

  const EmbreeScene& rays_;
  const scene::Mesh& mesh_;
  std::vector<std::uint32_t> vertices_;  // vertices_[i] is the vertex at the position of index i
  std::vector<glm::dvec3> face_normals_;
  std::vector<glm::dvec3> edge_normals_;    // three for each triangle
  std::vector<glm::dvec3> corner_normals_;  // one for each vertex
  std::size_t open_edges_ = 0;
  double outwards_ = 1.0;  // -1 where normals point inwards
};

// The height of a scene's highest surface over a point of the map, as a height field keeps it.
class HighestSurface {
 public:
  // The constructor keeps references to both; `rays` must be made of that scene.
  HighestSurface(const EmbreeScene& rays, const scene::Scene& scene);

  // Returns metres relative to the scene's origin, or nothing where no surface is. A ray straight down finds
  // it and passes where a material is cut out. The scene's edges belong to its surface. Reentrant.
  std::optional<double> at(glm::dvec2 xz) const;

 private:
  const EmbreeScene& rays_;
  double above_ = 0.0;      // the height at which rays begin, over everything
  glm::vec2 middle_{0.0F};  // the middle of the bounds
};

}  // namespace penumbra::reference
