#include "parameters/screen_to_world.h"

#include <cmath>
#include <glm/matrix.hpp>

namespace penumbra::parameters {

namespace {

using Mat4 = glm::mat<4, 4, long double>;
using Vec4 = glm::vec<4, long double>;

bool is_finite(const Mat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) return false;
    }
  }
  return true;
}

Mat4 screen_to_clip(const ScreenConventions& conventions) {
  Mat4 matrix(1.0L);
  matrix[0][0] = 2.0L;
  matrix[3][0] = -1.0L;
  matrix[1][1] = conventions.uv_starts_at_top ? -2.0L : 2.0L;
  matrix[3][1] = conventions.uv_starts_at_top ? 1.0L : -1.0L;
  if (!conventions.depth_is_zero_to_one) {
    matrix[2][2] = 2.0L;
    matrix[3][2] = -1.0L;
  }
  return matrix;
}

}  // namespace

std::optional<glm::dmat4> screen_to_world(const glm::dmat4& view, const glm::dmat4& gpu_projection,
                                          const ScreenConventions& conventions) {
  const Mat4 clip_to_world = glm::inverse(Mat4(view)) * glm::inverse(Mat4(gpu_projection));
  const Mat4 matrix = clip_to_world * screen_to_clip(conventions);
  if (!is_finite(matrix)) return std::nullopt;
  return glm::dmat4(matrix);
}

}  // namespace penumbra::parameters
