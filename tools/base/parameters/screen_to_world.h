// The matrix from a pixel of a camera's depth texture to world space, S = inverse(projection * view) N.
//
// Spaces: (u, v, stored depth, 1) in, v from texel row 0; homogeneous world position out, to divide by its w.
// N maps the texture's coordinates to the device's clip space, by its conventions. Guarantees: computed in
// long double, each matrix inverted by itself, so that a distant camera and a near plane close to 0 cost no
// float precision.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>

namespace penumbra::parameters {

struct ScreenConventions {
  bool uv_starts_at_top = true;      // texel row 0 is clip y = +1 (Direct3D), not -1 (OpenGL)
  bool depth_is_zero_to_one = true;  // clip depth is stored as it is, not from -1 .. 1 (OpenGL)
};

// gpu_projection takes view space to the device's clip space, flipped and reversed as on the device. Returns
// nothing when a matrix is singular or not finite.
std::optional<glm::dmat4> screen_to_world(const glm::dmat4& view, const glm::dmat4& gpu_projection,
                                          const ScreenConventions& conventions);

}  // namespace penumbra::parameters
