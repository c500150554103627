// A mesh in Embree 3: built once, queried from many threads.
//
// Built with RTC_SCENE_FLAG_ROBUST, so that rays do not slip between triangles that share an edge. Space:
// relative to the scene's origin, metres. Both faces of a triangle block. Where a material is cut out rays
// pass, by a filter that Embree asks about each hit; cut-out triangles are a geometry of their own, so that
// no other hit is asked about. A blended triangle stops a ray with the probability of its opacity, so that
// the mean over rays is the transmittance, also of several triangles: Enderton et al., "Stochastic
// Transparency", I3D 2010. What is drawn for a ray and a triangle follows from both: the ray's origin,
// direction and id, and the triangle's number. So it is the same on any thread and in any packet, and where
// Embree asks twice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "scene/cut_out.h"
#include "scene/scene.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace penumbra::reference {

class EmbreeScene {
 public:
  // Keeps a reference to the scene's mesh. Throws InputError for an index outside the vertices and as
  // scene::CutOuts does, EnvironmentError when Embree fails or was built without filters and the scene has
  // cut-outs.
  explicit EmbreeScene(const scene::Scene& scene);
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCSceneTy* handle() const { return scene_.get(); }
  const scene::CutOuts& cut_outs() const { return cut_outs_; }

  // If any triangle is blended, rays of one origin and direction differ by their ids.
  bool any_blended() const { return cut_outs_.any_blended(); }

  // Returns the mesh's triangle of a hit's geomID and primID.
  std::size_t triangle(unsigned geometry, unsigned primitive) const {
    return triangles_.empty() ? primitive : triangles_[geometry][primitive];
  }

  // Returns how far along `direction` a ray first meets a surface, in lengths of `direction`, if that is less
  // than `farthest`.
  std::optional<float> first_hit(const glm::vec3& from, const glm::vec3& direction, float farthest) const;

 private:
  void attach(const scene::Mesh& mesh, const std::vector<std::uint32_t>& indices, unsigned geometry_id);
  void attach_apart(const scene::Mesh& mesh);

  scene::CutOuts cut_outs_;
  std::vector<std::vector<std::uint32_t>>
      triangles_;  // the triangles of each geometry; empty without cut-outs
  std::unique_ptr<RTCDeviceTy, void (*)(RTCDeviceTy*)> device_;
  std::unique_ptr<RTCSceneTy, void (*)(RTCSceneTy*)> scene_;
};

}  // namespace penumbra::reference
