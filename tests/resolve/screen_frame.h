// Built-in scenes drawn for passes over the screen: they are small, with an asymmetric lens. What such a pass
// should make of their camera depth is worked out here in double and in another way.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <optional>

#include "resolve/camera_image.h"
#include "scene/frame.h"
#include "scene/scene.h"

namespace penumbra::resolve {

inline scene::FrameSettings screen_settings(int cascades, bool reversed_z) {
  scene::FrameSettings settings;
  settings.shadows.cascades = cascades;
  settings.shadows.resolution = 1024;
  settings.shadows.normal_bias = 0.0;
  settings.shadows.reversed_z = reversed_z;
  settings.angular_diameter_degrees = 2.0;
  settings.width = 129;  // odd, so that half and quarter images have a column of their own
  settings.height = 73;
  settings.lens_shift = {0.15, -0.1};
  return settings;
}

// The world as a screen pass can know it.
class SeenByDepth {
 public:
  explicit SeenByDepth(const CameraImage& camera)
      : camera_(camera), matrix_(glm::mat4(camera.screen_to_world)) {}

  // The receivers of the whole image; w of the position is 0 where there is no surface, and a normal is 0
  // where none can be told.
  scene::Receivers receivers() const {
    scene::Receivers receivers;
    receivers.width = camera_.width;
    receivers.height = camera_.height;
    for (int y = 0; y < camera_.height; ++y) {
      for (int x = 0; x < camera_.width; ++x) {
        const std::optional<double> here = depth(x, y);
        receivers.position_ws.emplace_back(here ? glm::vec4(glm::vec3(position(x, y, *here)), 1.0f)
                                                : glm::vec4(0.0f));
        receivers.normal_ws.emplace_back(here ? glm::vec4(glm::vec3(normal(x, y, *here)), 0.0f)
                                              : glm::vec4(0.0f));
      }
    }
    receivers.position_relative = receivers.position_ws;
    return receivers;
  }

  std::optional<double> depth(int x, int y) const {
    if (x < 0 || y < 0 || x >= camera_.width || y >= camera_.height) return std::nullopt;
    const float stored = camera_.depth[static_cast<std::size_t>(y * camera_.width + x)];
    if (!(stored > 0.0f && stored < 1.0f)) return std::nullopt;
    return stored;
  }

  glm::dvec3 position(double x, double y, double depth) const {
    const glm::dvec4 h =
        matrix_ * glm::dvec4((x + 0.5) / camera_.width, (y + 0.5) / camera_.height, depth, 1.0);
    return glm::dvec3(h) / h.w;
  }

  // The normal of the plane through three points: the pixel, and one pixel right and down on the surface's
  // own slope.
  glm::dvec3 normal(int x, int y, double here) const {
    const std::optional<double> right = slope(x, y, 1, 0, here);
    const std::optional<double> down = slope(x, y, 0, 1, here);
    if (!right || !down) return glm::dvec3(0.0);
    const glm::dvec3 at = position(x, y, here);
    return glm::normalize(
        glm::cross(position(x + 1.0, y, here + *right) - at, position(x, y + 1.0, here + *down) - at));
  }

 private:
  // Of neighbours that agree to a sixteenth the smaller change is taken. Otherwise it is the side that runs
  // straighter; a side of which that is not known stands between a straight one and an edge.
  std::optional<double> slope(int x, int y, int dx, int dy, double here) const {
    std::array<std::optional<double>, 2> slopes;
    std::array<std::optional<double>, 2> bends;
    for (const int side : {0, 1}) {
      const int sign = 2 * side - 1;
      const std::optional<double> next = depth(x + sign * dx, y + sign * dy);
      if (!next) continue;
      slopes[side] = sign * (*next - here);
      const std::optional<double> after = depth(x + 2 * sign * dx, y + 2 * sign * dy);
      if (after) bends[side] = std::abs(sign * (*after - *next) - *slopes[side]);
    }
    if (!slopes[0] || !slopes[1]) return slopes[0] ? slopes[0] : slopes[1];
    const double steeper = std::max(std::abs(*slopes[0]), std::abs(*slopes[1]));
    const bool agree = std::abs(*slopes[0] - *slopes[1]) <= steeper / 16.0;
    const double unknown = std::abs(*slopes[0] - *slopes[1]) / 2.0;
    const double bend_before = bends[0].value_or(unknown);
    const double bend_after = bends[1].value_or(unknown);
    if (!agree && bend_before != bend_after) return bend_before < bend_after ? slopes[0] : slopes[1];
    return std::abs(*slopes[1]) < std::abs(*slopes[0]) ? slopes[1] : slopes[0];
  }

  const CameraImage& camera_;
  glm::dmat4 matrix_;
};

}  // namespace penumbra::resolve
