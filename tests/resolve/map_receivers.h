// A scene's map of one cascade, and a receiver at each of its texels' centres.
#pragma once

#include <functional>
#include <glm/matrix.hpp>

#include "resolve/synthetic_frame.h"
#include "resolve/test_device.h"
#include "scene/scene.h"

namespace penumbra::testing_frames {

// The frame has as many pixels as texels.
inline scene::Frame map_of(const scene::Scene& scene, int size, bool reversed_z) {
  scene::FrameSettings settings;
  settings.shadows.cascades = 1;
  settings.shadows.resolution = size;
  settings.shadows.distance_metres = scene.shadow_distance_metres;
  settings.shadows.depth_bias = settings.shadows.normal_bias = 0.0;
  settings.shadows.reversed_z = reversed_z;
  settings.width = settings.height = size;
  return scene::rasterise(test_device(), scene, settings);
}

inline glm::dvec3 position_at(const scene::Frame& frame, int x, int y, double depth) {
  const glm::dvec4 shadow((x + 0.5) / frame.atlas.width, (y + 0.5) / frame.atlas.height, depth, 1.0);
  return glm::dvec3(glm::inverse(frame.cascades.cascades[0].world_to_shadow) * shadow);
}

// `depth` is the stored depth of a texel's receiver.
inline void place_receivers(scene::Frame& frame, const std::function<double(int x, int y)>& depth) {
  choose_cascade(frame.cascades, 0);
  const int size = frame.atlas.width;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const auto at = static_cast<std::size_t>(y * size + x);
      frame.receivers.position_ws[at] = glm::vec4(glm::vec3(position_at(frame, x, y, depth(x, y))), 1.0F);
      frame.receivers.normal_ws[at] = {0.0F, 1.0F, 0.0F, 0.0F};
    }
}

}  // namespace penumbra::testing_frames
