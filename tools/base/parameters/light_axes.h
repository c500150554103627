// The axes of a light's own space. Internal to this folder.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace penumbra::parameters {

// The axes are right, up and forward (the direction in which the light travels), as Unity's transforms have
// them: cross(right, up) = forward.
struct LightAxes {
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 forward;

  glm::dvec3 into(const glm::dvec3& world) const {
    return {glm::dot(right, world), glm::dot(up, world), glm::dot(forward, world)};
  }
};

inline LightAxes axes_of(const glm::dvec3& direction) {
  const glm::dvec3 forward = glm::normalize(direction);
  // The hint is world up, except for a light within 8 degrees of the vertical: there the cross product loses
  // its digits.
  const glm::dvec3 hint = std::abs(forward.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 right = glm::normalize(glm::cross(hint, forward));
  return {right, glm::cross(forward, right), forward};
}

}  // namespace penumbra::parameters
