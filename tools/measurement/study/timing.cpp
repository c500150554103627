#include "study/timing.h"

#include <algorithm>
#include <cmath>

namespace penumbra::study {
namespace {

double quantile(const std::vector<double>& sorted, double fraction) {
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

}  // namespace

std::optional<Timing> summarise(std::vector<double> milliseconds) {
  if (milliseconds.empty()) return std::nullopt;
  std::sort(milliseconds.begin(), milliseconds.end());
  return Timing{quantile(milliseconds, 0.5), quantile(milliseconds, 0.75) - quantile(milliseconds, 0.25)};
}

}  // namespace penumbra::study
