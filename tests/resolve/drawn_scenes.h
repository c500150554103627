// Built-in scenes for passes over the screen, drawn once per scene, cascade count, depth direction and
// format.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "resolve/screen_frame.h"
#include "resolve/test_device.h"

namespace penumbra::resolve {

inline const scene::Frame& drawn(const std::string& scene, int cascades, bool reversed_z,
                                 scene::DepthFormat format = scene::DepthFormat::d32) {
  struct Drawn {
    explicit Drawn(const std::string& name)
        : scene(scene::built_in(name)), rasteriser(test_device(), scene) {}
    scene::Scene scene;
    scene::Rasteriser rasteriser;
    std::map<std::tuple<int, bool, scene::DepthFormat>, scene::Frame> frames;
  };
  static std::map<std::string, std::unique_ptr<Drawn>> scenes;
  std::unique_ptr<Drawn>& drawn = scenes[scene];
  if (drawn == nullptr) drawn = std::make_unique<Drawn>(scene);
  const auto [frame, is_new] = drawn->frames.try_emplace({cascades, reversed_z, format});
  if (is_new) {
    scene::FrameSettings settings = screen_settings(cascades, reversed_z);
    settings.shadows.distance_metres = drawn->scene.shadow_distance_metres;
    settings.format = format;
    frame->second = drawn->rasteriser.frame(settings);
  }
  return frame->second;
}

}  // namespace penumbra::resolve
