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

  // Metres, relative to the scene's origin; nothing where no surface is. By one ray straight down, which
  // passes where a material is cut out. Reentrant.
  std::optional<double> at(glm::dvec2 xz) const;

 private:
  const EmbreeScene& rays_;
  double above_;  // where rays begin: over everything
};

}  // namespace penumbra::reference
