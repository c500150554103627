// How high the highest surface of a scene stands over a point of the map: what a height field keeps of it.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "reference/embree_scene.h"

namespace penumbra::reference {

class HighestSurface {
 public:
  // Keeps references to both; `rays` is of that scene.
  HighestSurface(const EmbreeScene& rays, const scene::Scene& scene);

  // Metres, relative to the scene's origin; nothing where no surface is. By a ray straight down, which
  // passes where a material is cut out; the scene's edges belong to it. Reentrant.
  std::optional<double> at(glm::dvec2 xz) const;

 private:
  const EmbreeScene& rays_;
  double above_ = 0.0;      // where rays begin: over everything
  glm::vec2 middle_{0.0F};  // of the bounds
};

}  // namespace penumbra::reference
