#include "study/shimmer.h"

#include <cmath>
#include <stdexcept>

namespace penumbra::study {

std::optional<double> shimmer_of(const std::vector<std::vector<float>>& frames, int width,
                                 std::span<const float> t1, std::span<const std::uint8_t> valid) {
  if (width <= 0 || t1.size() != valid.size() || t1.size() % static_cast<std::size_t>(width) != 0) {
    throw std::invalid_argument("a reference that does not fit the picture's width");
  }
  for (const std::vector<float>& frame : frames) {
    if (frame.size() != t1.size()) throw std::invalid_argument("the frames of a pan differ in size");
  }
  double squares = 0.0;
  std::size_t changes = 0;
  for (std::size_t pixel = 0; pixel < t1.size(); ++pixel) {
    const auto t = static_cast<double>(t1[pixel]);
    const bool counts = valid[pixel] != 0 && t > kUmbraBelow && t < kLitAbove;
    const bool stays = pixel % static_cast<std::size_t>(width) + 1 >= frames.size();
    if (!counts || !stays) continue;
    for (std::size_t k = 1; k < frames.size(); ++k) {
      const double change =
          static_cast<double>(frames[k][pixel - k]) - static_cast<double>(frames[k - 1][pixel - k + 1]);
      squares += change * change;
      ++changes;
    }
  }
  if (changes == 0) return std::nullopt;
  return std::sqrt(squares / static_cast<double>(changes));
}

}  // namespace penumbra::study
