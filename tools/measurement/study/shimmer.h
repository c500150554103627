// Shimmer: the flicker of a technique's picture while the camera pans slowly.
//
// The picture moves by one pixel per frame, as with a lens shift: every point of a surface stays on pixel
// centres, the shadow map does not change, and the light on each point does not change. All changes are the
// technique's: noise that is fixed to the screen, or changes with every frame, and grids of its own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "study/metrics.h"

namespace penumbra::study {

// RMS change of visibility from one frame to the next, at the same points, in penumbra.
struct Shimmer {
  int frames = 0;
  std::optional<double> static_noise;     // noise that is fixed to the screen
  std::optional<double> per_frame_noise;  // noise that changes every frame

  bool operator==(const Shimmer&) const = default;
};

// frames[k] is the picture moved k columns to the left; t1 and valid are those of frames[0]. Points that
// leave the picture are ignored. The result is absent without a point in penumbra.
std::optional<double> shimmer_of(const std::vector<std::vector<float>>& frames, int width,
                                 std::span<const float> t1, std::span<const std::uint8_t> valid);

}  // namespace penumbra::study
