// A frame as a photograph would show it: sun and sky on materials, tone mapped. Only the sun's visibility
// comes from outside, so that pictures of two techniques differ by their shadows alone.
//
// The frame is rasterised at `supersampling` times the size of the picture, each way, and the technique
// answers for each of those samples. Samples are tone mapped first and then averaged in linear light, as an
// eye averages a screen. Averaging before the tone curve would leave the edges of bright things jagged.
// Light through leaves and cloth comes past whatever stands behind them, which no map of the seen side knows.
// That visibility is ray-traced in the same way for every technique.
// The result is deterministic: the same scene, frame and settings give the same numbers.
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
  int sun_rays = 1024;          // for the visibility behind leaves, as in reference::TraceOptions
  std::uint64_t seed = 1;
  int jobs = 0;
  std::filesystem::path cache;  // empty: the user's cache folder
};

// `stage` names the work in progress; `done` and `total` count `unit`s.
using LitProgress =
    std::function<void(std::string_view stage, double done, double total, std::string_view unit)>;

class LitFrame {
 public:
  // The constructor prepares everything but the sun's visibility. Results that take long are kept on disk by
  // content. Throws InputError for what seen_materials refuses, and a supersampling that does not divide
  // the frame; also throws platform::Interrupted.
  LitFrame(const scene::Scene& scene, const scene::Frame& frame, const LitSettings& settings,
           const LitProgress& progress);

  int width() const { return width_; }  // the picture's width
  int height() const { return height_; }

  // Returns sRGB-encoded colours in [0, 1], row 0 at the top. `visibility` has a value for each pixel of the
  // frame; one that is not a number counts as 0, and pixels that are no receiver count as 1.
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
