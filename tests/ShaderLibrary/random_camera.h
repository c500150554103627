// Cameras in perspective, as matrices from the screen to the world.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "ShaderLibrary/inputs.h"

namespace penumbra::shader_library_tests {

using Vector = glm::vec<3, long double>;

struct RandomCamera {
  std::array<float, 16> rows;  // rows that take (uv, depth, 1) to homogeneous world
  Vector eye;
};

// The lenses have 20 to 100 degrees and are asymmetric; the near planes lie at 1 cm to 1 m; depth direction
// and row order are either.
inline RandomCamera random_camera(Random& random) {
  const auto direction = [&] {
    return glm::normalize(
        Vector(random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f)));
  };
  const Vector forward = direction();
  const Vector right = glm::normalize(glm::cross(direction(), forward));
  const Vector up = glm::cross(forward, right);
  const long double tangent = random.between(0.18f, 1.2f);
  const Vector across = right * (2.0L * tangent * 16.0L / 9.0L);
  const Vector down = up * (tangent * (random.integer(0, 1) == 0 ? -2.0L : 2.0L));
  const Vector origin = forward - across * static_cast<long double>(random.between(0.3f, 0.7f)) -
                        down * static_cast<long double>(random.between(0.3f, 0.7f));
  const Vector eye(random.between(-50.0f, 50.0f), random.between(-50.0f, 50.0f),
                   random.between(-50.0f, 50.0f));
  const long double near = std::pow(10.0f, random.between(-2.0f, 0.0f));
  const long double far = near * 1000.0L;
  const bool reversed = random.integer(0, 1) == 0;
  const long double scale = (reversed ? 1.0L : -1.0L) * near * far / (far - near);
  const long double offset = reversed ? -near / (far - near) : far / (far - near);
  RandomCamera camera;
  camera.eye = eye;
  for (int row = 0; row < 4; ++row) {
    const auto part = [&](const Vector& v, long double w) { return row < 3 ? v[row] : w; };
    const long double of_depth = part(eye, 1.0L) / scale;
    const long double columns[] = {part(across, 0.0L), part(down, 0.0L), of_depth,
                                   part(origin, 0.0L) - offset * of_depth};
    for (int k = 0; k < 4; ++k) camera.rows[std::size_t(4 * row + k)] = static_cast<float>(columns[k]);
  }
  return camera;
}

}  // namespace penumbra::shader_library_tests
