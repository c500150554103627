// A row of a matrix, whose columns glm keeps together, without its fourth number.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace penumbra::parameters {

inline glm::dvec3 matrix_row(const glm::dmat4& matrix, int row) {
  return {matrix[0][row], matrix[1][row], matrix[2][row]};
}

}  // namespace penumbra::parameters
