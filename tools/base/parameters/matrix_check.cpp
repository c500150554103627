#include "parameters/matrix_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "parameters/matrix_row.h"

namespace penumbra::parameters {

namespace {

// Matrices are dumped as floats, often with six or seven digits.
constexpr double kRounding = 2e-5;

std::string why_not_affine(const glm::dmat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(m[column][row])) {
        return fmt::format("is not finite in row {}, column {}", row, column);
      }
    }
  }
  const glm::dvec4 last(m[0][3], m[1][3], m[2][3], m[3][3]);
  if (last == glm::dvec4(0, 0, 0, 1)) return {};
  const glm::dvec4 transposed_last = m[3];
  if (transposed_last == glm::dvec4(0, 0, 0, 1)) {
    return "is affine only in the other matrix order: matrix_order is wrong";
  }
  return fmt::format("is a perspective projection: its last row is {} {} {} {}, not 0 0 0 1", last.x, last.y,
                     last.z, last.w);
}

std::string why_not_perpendicular(const glm::dmat4& m) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const glm::dvec3 a = matrix_row(m, i);
    const glm::dvec3 b = matrix_row(m, j);
    const double cosine = glm::dot(a, b) / (glm::length(a) * glm::length(b));
    if (std::abs(cosine) > kRounding) {
      return fmt::format("is sheared: the angle between rows {} and {} is {:.6g} degrees, not 90",
                         std::min(i, j), std::max(i, j),
                         std::acos(std::clamp(cosine, -1.0, 1.0)) * 57.29577951308232);
    }
  }
  return {};
}

std::string why_singular(const glm::dmat4& m) {
  double lengths = 1.0;
  for (int row = 0; row < 3; ++row) {
    const double length = glm::length(matrix_row(m, row));
    if (!(length > 0.0)) return fmt::format("is singular: row {} is zero", row);
    lengths *= length;
  }
  const double volume = std::abs(glm::determinant(glm::dmat3(m))) / lengths;
  if (!(volume > 1e-9)) return "is singular: its rows lie in one plane";
  return {};
}

}  // namespace

std::string why_not_rigid(const glm::dmat4& matrix) {
  if (std::string why = why_not_affine(matrix); !why.empty()) return why;
  if (std::string why = why_singular(matrix); !why.empty()) return why;
  for (int row = 0; row < 3; ++row) {
    const double length = glm::length(matrix_row(matrix, row));
    if (std::abs(length - 1.0) > kRounding) {
      return fmt::format("is scaled: row {} has length {:.9g}, not 1", row, length);
    }
  }
  return why_not_perpendicular(matrix);
}

std::string why_not_light_projection(const glm::dmat4& matrix, const glm::dvec2& tile_size) {
  if (std::string why = why_not_affine(matrix); !why.empty()) return why;
  if (std::string why = why_singular(matrix); !why.empty()) return why;
  if (std::string why = why_not_perpendicular(matrix); !why.empty()) return why;
  const double x = glm::length(matrix_row(matrix, 0)) / tile_size.x;
  const double y = glm::length(matrix_row(matrix, 1)) / tile_size.y;
  if (std::abs(x - y) > kRounding * std::max(x, y)) {
    return fmt::format("is stretched: a metre is {:.9g} of the tile across and {:.9g} of it up", x, y);
  }
  return {};
}

glm::dmat4 matrix_from(const double* numbers, bool row_major) {
  glm::dmat4 matrix(1.0);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      matrix[column][row] = row_major ? numbers[row * 4 + column] : numbers[column * 4 + row];
    }
  }
  return matrix;
}

}  // namespace penumbra::parameters
