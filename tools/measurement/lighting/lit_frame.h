// A frame as a photograph would show it: sun and sky on materials, tone mapped. The sun's visibility is the
// only thing it is told from outside, so that pictures of two techniques differ by their shadows alone.
//
// The frame is rasterised at `supersampling` times the size of the picture, each way, and the technique
// answers for each of those samples; samples are tone mapped and then averaged, in linear light, as an eye
// averages a screen: averaging before the tone curve would leave the edges of bright things jagged.
// Light through leaves and cloth comes past whatever stands behind them, which no map of the seen side knows:
// that visibility is ray-traced, for every technique the same.
// Deterministic: the same scene, frame and settings give the same numbers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "scene/frame.h"
#include "scene/scene.h"

namespace penumbra::lighting {

struct LitSettings {
  int supersampling = 2;  // samples of a pixel each way; divides the frame's width and height
  double exposure_stops = 0.0;
  int sky_rays = 128;  // per pixel, shared among its samples
  double turbidity = 2.5;
  double light_degrees = 0.53;  // angular diameter of the sun
  int sun_rays = 1024;          // of the visibility behind leaves, as reference::TraceOptions has it
  std::uint64_t seed = 1;
  int jobs = 0;
  std::filesystem::path cache;  // empty: the user's cache folder
};

// stage names what is being done, done and total count `unit`s.
using LitProgress =
    std::function<void(std::string_view stage, double done, double total, std::string_view unit)>;

class LitFrame {
 public:
  // Everything but the sun's visibility. Kept on disk by content where it takes long. Throws InputError for
  // what seen_materials refuses, a spot light, and a supersampling that does not divide the frame;
  // platform::Interrupted.
  LitFrame(const scene::Scene& scene, const scene::Frame& frame, const LitSettings& settings,
           const LitProgress& progress);

  int width() const { return width_; }  // of the picture
  int height() const { return height_; }

  // sRGB-encoded colours in [0, 1], row 0 at the top. visibility: of each pixel of the frame; not a number
  // counts as 0, and pixels that are no receiver as 1.
  std::vector<glm::vec3> picture(std::span<const float> visibility) const;

 private:
  int width_ = 0;
  int height_ = 0;
  int supersampling_ = 1;
  std::vector<glm::vec3> by_sun_;  // per unit of visibility; exposed
  std::vector<glm::vec3> others_;  // all other light; exposed
  std::vector<std::uint8_t> receives_;
};

}  // namespace penumbra::lighting
