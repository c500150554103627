// The seam between cascades: the change of a technique's error where neighbouring pixels read different ones.
//
// From one cascade to the next the texels' size changes, and with it a filter's error. The eye sees a change
// along a line, not noise: so changes are first averaged along the border, in blocks of kSeamBlock pixels.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace penumbra::study {

inline constexpr int kSeamBlock = 16;  // pixels, each way
inline constexpr int kSeamPairs = 8;   // fewest pairs of a block

struct Seam {
  std::size_t pairs = 0;  // pairs of neighbouring penumbra pixels, one in each cascade
  // RMS over blocks of the mean change of error from the nearer cascade to the next.
  std::optional<double> step;
  // The same between two rows of one cascade: the part that the technique's noise and its error's own slope
  // cause.
  std::optional<double> elsewhere;

  bool operator==(const Seam&) const = default;
};

struct SeamImages {
  int width = 0;
  std::span<const int> cascade;  // cascade of each pixel; -1 where it is not counted
  std::span<const float> t1;
  std::span<const float> result;
  bool everywhere = false;  // all pixels count, not penumbra pixels alone
};

// Throws std::invalid_argument for images of different sizes.
Seam seam_of(const SeamImages& images);

}  // namespace penumbra::study
