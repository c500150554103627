// Checks of the form of a 4x4 matrix. An empty result means yes; otherwise it is the reason, to follow the
// matrix's name.
#pragma once

#include <glm/mat4x4.hpp>
#include <string>

namespace penumbra::parameters {

// The matrix may have rotation (or reflection) and translation only.
std::string why_not_rigid(const glm::dmat4& matrix);

// The matrix must be orthographic and seen along the light: affine, invertible, rows perpendicular, and the
// first two of equal length once each is divided by its tile's size in the atlas.
std::string why_not_light_projection(const glm::dmat4& matrix, const glm::dvec2& tile_size);

// Returns row-major numbers as a matrix; column-major ones are transposed.
glm::dmat4 matrix_from(const double* numbers, bool row_major);

}  // namespace penumbra::parameters
