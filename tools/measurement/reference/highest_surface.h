// The height of a scene's highest surface over a point of the map, as a height field keeps it.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "reference/embree_scene.h"

namespace penumbra::reference {

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
