// How much a technique's picture flickers while the camera pans slowly.
//
// The picture slides by one pixel a frame, as a lens shift does it: every point of a surface stays on pixel
// centres, the shadow map stays as it is, and the light on each point does not change. What changes is the
// technique's: noise that stands on the screen, or moves with every frame, and grids of its own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "study/metrics.h"

namespace penumbra::study {

// RMS change of visibility from one frame to the next, at the same points, in penumbra.
struct Shimmer {
  int frames = 0;
  std::optional<double> static_noise;     // noise stands still on the screen
  std::optional<double> per_frame_noise;  // noise differs from frame to frame

  bool operator==(const Shimmer&) const = default;
};

// frames[k] is the picture moved k columns to the left; t1 and valid are of frames[0]. Points that leave the
// picture count nowhere. Absent without a point in penumbra.
std::optional<double> shimmer_of(const std::vector<std::vector<float>>& frames, int width,
                                 std::span<const float> t1, std::span<const std::uint8_t> valid);

}  // namespace penumbra::study
