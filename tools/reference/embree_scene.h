// A mesh in Embree 3: built once, asked from many threads.
//
// Built with RTC_SCENE_FLAG_ROBUST, so that rays do not slip between triangles that share an edge. Space:
// relative to the scene's origin, metres. Both faces of a triangle block.
#pragma once

#include "scene/scene.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace penumbra::reference {

class EmbreeScene {
 public:
  // Throws InputError for an index outside the vertices, EnvironmentError when Embree fails.
  explicit EmbreeScene(const scene::Mesh& mesh);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCSceneTy* handle() const { return scene_; }

 private:
  RTCDeviceTy* device_ = nullptr;
  RTCSceneTy* scene_ = nullptr;
};

}  // namespace penumbra::reference
