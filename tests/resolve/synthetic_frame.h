// Frames made by hand: they have a map whose every texel is a formula, and receivers at chosen places of one
// tile.
#pragma once

#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "parameters/cascades.h"
#include "scene/frame.h"

namespace penumbra::testing_frames {

struct FrameSetup {
  parameters::Camera camera;
  parameters::Light light;
  parameters::ShadowSettings shadows;
  int cascade = 0;  // the one every receiver is in
};

// A depth for the texel centre (u, v) of a tile, both in [0, 1], and of the tile's index.
using TexelDepth = std::function<float(double u, double v, int tile)>;

// The place where a receiver stands: tile UV and stored depth.
using TilePoint = glm::dvec3;

inline scene::ShadowAtlas make_atlas(const parameters::CascadeSet& set, const TexelDepth& depth) {
  scene::ShadowAtlas atlas;
  atlas.width = set.atlas_width;
  atlas.height = set.atlas_height;
  const int columns = set.atlas_width / set.tile_resolution;
  for (int y = 0; y < atlas.height; ++y) {
    for (int x = 0; x < atlas.width; ++x) {
      const int tile = (y / set.tile_resolution) * columns + x / set.tile_resolution;
      const double u = (x % set.tile_resolution + 0.5) / set.tile_resolution;
      const double v = (y % set.tile_resolution + 0.5) / set.tile_resolution;
      atlas.depth.push_back(depth(u, v, tile));
    }
  }
  const auto bytes = std::as_bytes(std::span<const float>(atlas.depth));
  atlas.texels.assign(bytes.begin(), bytes.end());
  return atlas;
}

// Every split sphere but the chosen cascade's is empty, and that one holds the world, so that receivers may
// stand anywhere in its tile.
inline void choose_cascade(parameters::CascadeSet& set, int chosen) {
  for (parameters::Cascade& cascade : set.cascades) {
    cascade.split_sphere.w = cascade.index == chosen ? 1e9 : 0.0;
  }
}

inline glm::dvec3 world_position(const parameters::Cascade& cascade, const TilePoint& point) {
  const glm::dvec4 tile = cascade.offset_scale;
  const glm::dvec4 shadow(tile.x + point.x * tile.z, tile.y + point.y * tile.w, point.z, 1.0);
  return glm::dvec3(glm::inverse(cascade.world_to_shadow) * shadow);
}

inline scene::Frame make_frame(const FrameSetup& setup, const TexelDepth& depth,
                               const std::vector<TilePoint>& receivers, int width) {
  scene::Frame frame;
  frame.scene_name = "synthetic";
  frame.camera = setup.camera;
  frame.cascades = parameters::fit_cascades(setup.camera, setup.light, setup.shadows);
  choose_cascade(frame.cascades, setup.cascade);
  frame.settings.shadows = setup.shadows;
  frame.settings.angular_diameter_degrees = setup.light.angular_diameter_degrees;
  frame.settings.format = scene::DepthFormat::d32;
  frame.atlas = make_atlas(frame.cascades, depth);

  const parameters::Cascade& cascade = frame.cascades.cascades.at(static_cast<std::size_t>(setup.cascade));
  const glm::dvec3 to_light = -frame.cascades.light_direction;
  frame.receivers.width = width;
  frame.receivers.height = static_cast<int>(receivers.size()) / width;
  for (const TilePoint& point : receivers) {
    frame.receivers.position_ws.emplace_back(glm::vec3(world_position(cascade, point)), 1.0f);
    frame.receivers.normal_ws.emplace_back(glm::vec3(to_light), 0.0f);
  }
  frame.settings.width = frame.receivers.width;
  frame.settings.height = frame.receivers.height;
  return frame;
}

inline float nearest_depth(bool reversed_z) {
  return reversed_z ? 1.0f : 0.0f;
}
inline float farthest_depth(bool reversed_z) {
  return reversed_z ? 0.0f : 1.0f;
}

}  // namespace penumbra::testing_frames
