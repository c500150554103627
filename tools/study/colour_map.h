// Numbers per pixel made visible: visibility, signed error, fetches.
//
// Pixels without a receiver are one pale blue-grey, values that are no number (or no visibility) magenta:
// neither colour occurs in any ramp.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "study/picture.h"

namespace penumbra::study {

inline constexpr Rgb kNoReceiver{168, 180, 196};
inline constexpr Rgb kInvalid{255, 0, 255};

// Black 0 to white 1, linear in the stored value: a picture of numbers, not of light.
Rgb visibility_colour(double visibility);

// -1 (too dark) blue, 0 white, +1 (too bright: a leak) red; both arms are straight lines to ends of equal
// luma (Rec. 709, within 1 %), so that equal errors of either sign weigh the same in print. Saturates beyond
// +-1.
Rgb error_colour(double share);

// 0 black to 1 white through colour, by D. A. Green's cubehelix (2011, "A colour scheme for the display of
// astronomical intensity images", eq. 2; start 0.5, -1.5 rotations, hue 1): perceived intensity equals the
// value, so the ramp also reads in grey. Clamped to [0, 1].
Rgb fetch_colour(double share);

// What all pictures of one frame share. Row 0 at the top; valid 0: no receiver.
struct PixelGrid {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> valid;
};

Picture visibility_picture(const PixelGrid& grid, std::span<const float> visibility);
Picture error_picture(const PixelGrid& grid, std::span<const float> result, std::span<const float> reference,
                      double full_scale);
Picture fetch_picture(const PixelGrid& grid, std::span<const std::uint32_t> fetches, double full_scale);

// Grey: each count as it is, 255 for larger ones and 0 where there is no receiver.
Picture count_picture(const PixelGrid& grid, std::span<const std::uint32_t> counts);

// Colours in [0, 1], row 0 at the top, as they are.
Picture colour_picture(int width, int height, std::span<const glm::vec3> colours);

// A horizontal strip of a ramp for a legend: the first column is `from`, the last `to`.
Picture ramp_strip(Rgb (*ramp)(double), double from, double to);

}  // namespace penumbra::study
