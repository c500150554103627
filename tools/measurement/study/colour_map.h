// Visualises numbers per pixel: visibility, signed error, fetches.
//
// Pixels without a receiver are a pale blue-grey, values that are NaN (or not a visibility) are magenta:
// neither colour occurs in any ramp.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "study/picture.h"

namespace penumbra::study {

inline constexpr Rgb kNoReceiver{168, 180, 196};
inline constexpr Rgb kInvalid{255, 0, 255};

// The scale runs from black at 0 to white at 1, linear in the stored value: a picture of numbers, not of
// light.
Rgb visibility_colour(double visibility);

// The scale runs from blue at -1 (too dark) over white at 0 to vermilion at +1 (too bright: a leak), two hues
// that people with every common kind of colour blindness distinguish. Both arms are straight lines to ends of
// equal luma (Rec. 709, within 1 %), so that equal errors of either sign weigh the same in print. Values
// beyond +-1 are clamped.
Rgb error_colour(double share);

// The scale runs from dark blue at 0 to yellow at 1 by cividis (J. R. Nunez, C. R. Anderton, R. S. Renslow,
// "Optimizing colormaps with consideration for color vision deficiency to enable accurate interpretation of
// scientific data", PLOS ONE 2018): lightness rises evenly, and colour-blind people see the same map. It
// consists of straight lines between ten of its colours, and the argument is clamped to [0, 1].
Rgb fetch_colour(double share);

// Categories, in colours that colour-blind people can distinguish: M. Okabe and K. Ito, "Color Universal
// Design" (2008).
enum class Category { orange, sky_blue, bluish_green, yellow, blue, vermillion, reddish_purple };
Rgb category_colour(Category category);

// The properties that all pictures of one frame share. Row 0 is at the top; `valid` is 0 where there is no
// receiver.
struct PixelGrid {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> valid;
};

Picture visibility_picture(const PixelGrid& grid, std::span<const float> visibility);
Picture error_picture(const PixelGrid& grid, std::span<const float> result, std::span<const float> reference,
                      double full_scale);
Picture fetch_picture(const PixelGrid& grid, std::span<const std::uint32_t> fetches, double full_scale);

// Draws grey: each count as it is, 255 for larger ones and 0 where there is no receiver.
Picture count_picture(const PixelGrid& grid, std::span<const std::uint32_t> counts);

// Draws colours in [0, 1] without a map, row 0 at the top.
Picture colour_picture(int width, int height, std::span<const glm::vec3> colours);

// Draws a horizontal strip of a ramp for a legend: the first column is `from`, the last `to`.
Picture ramp_strip(Rgb (*ramp)(double), double from, double to);

}  // namespace penumbra::study
