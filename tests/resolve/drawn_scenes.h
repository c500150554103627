// Built-in scenes for passes over the screen are drawn once per scene, cascade count, depth direction and
// format.
#pragma once

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "resolve/screen_frame.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {

// The built-in scenes at the small pictures of these tests, but for the garden, which is made for large ones:
// most of its 474,000 triangles are narrower than a pixel here.
inline std::vector<std::string> scenes_for_small_pictures() {
  std::vector<std::string> names = scene::built_in_names();
  std::erase(names, "garden");
  return names;
}

// map_size is the atlas's, in texels; 0 means that of screen_settings.
inline const scene::Frame& drawn(const std::string& scene, int cascades, bool reversed_z,
                                 scene::DepthFormat format = scene::DepthFormat::d32, int map_size = 0) {
  struct Drawn {
    explicit Drawn(const std::string& name)
        : scene(scene::built_in(name)), rasteriser(test_device(), scene) {}
    scene::Scene scene;
    scene::Rasteriser rasteriser;
    std::map<std::tuple<int, bool, scene::DepthFormat, int>, scene::Frame> frames;
  };
  static KeptOnDevice<std::map<std::string, std::unique_ptr<Drawn>>> scenes;
  std::unique_ptr<Drawn>& drawn = (*scenes)[scene];
  if (drawn == nullptr) drawn = std::make_unique<Drawn>(scene);
  const auto [frame, is_new] = drawn->frames.try_emplace({cascades, reversed_z, format, map_size});
  if (is_new) {
    scene::FrameSettings settings = screen_settings(cascades, reversed_z);
    settings.shadows.distance_metres = drawn->scene.shadow_distance_metres;
    settings.format = format;
    if (map_size > 0) settings.shadows.resolution = map_size;
    frame->second = drawn->rasteriser.frame(settings);
  }
  return frame->second;
}

// The same casters and receivers under a light of another angular diameter.
inline scene::Frame under_disc(scene::Frame frame, double degrees) {
  const double wider =
      std::tan(degrees * M_PI / 360.0) / std::tan(frame.settings.angular_diameter_degrees * M_PI / 360.0);
  for (parameters::Cascade& cascade : frame.cascades.cascades) {
    cascade.depth_to_radial *= wider;
    cascade.radial_to_depth = 1.0 / cascade.depth_to_radial;
  }
  frame.settings.angular_diameter_degrees = frame.cascades.angular_diameter_degrees = degrees;
  return frame;
}

}  // namespace penumbra::resolve
