// Repeated timings reduced to the two figures a record keeps.
#pragma once

#include <optional>
#include <vector>

namespace penumbra::study {

// Milliseconds of one frame. The spread is the interquartile range: neither figure is sensitive to outliers.
struct Timing {
  double median_ms = 0.0;
  double spread_ms = 0.0;

  bool operator==(const Timing&) const = default;
};

// Quartiles by linear interpolation between order statistics; absent without a sample.
std::optional<Timing> summarise(std::vector<double> milliseconds);

}  // namespace penumbra::study
