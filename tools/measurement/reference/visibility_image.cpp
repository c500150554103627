#include "reference/visibility_image.h"

#include <cmath>
#include <utility>

namespace penumbra::reference {

VisibilityImage from_half_counts(ImageSize size, std::span<const HalfCounts> counts,
                                 std::vector<std::uint8_t> valid, int samples) {
  VisibilityImage image{size.width, size.height, {}, std::move(valid), 0.0, samples};
  image.visibility.assign(counts.size(), 1.0F);
  double squares = 0.0;
  std::size_t penumbra_pixels = 0;
  for (std::size_t pixel = 0; pixel < counts.size(); ++pixel) {
    if (image.valid[pixel] == 0) continue;
    const double first = counts[pixel].first;
    const double second = counts[pixel].second;
    const double visibility = (first + second) / samples;
    image.visibility[pixel] = static_cast<float>(visibility);
    if (visibility <= 0.02 || visibility >= 0.98) continue;
    const double half_difference = (first - second) / samples;  // (A - B) / 2, A = 2 first / samples
    squares += half_difference * half_difference;
    ++penumbra_pixels;
  }
  if (penumbra_pixels > 0) image.noise_floor = std::sqrt(squares / static_cast<double>(penumbra_pixels));
  return image;
}

}  // namespace penumbra::reference
