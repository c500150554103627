// The reduction of repeated timings to the two figures that a record keeps.
#pragma once

#include <optional>
#include <vector>

namespace penumbra::study {

// The milliseconds of one frame. The spread is the interquartile range: neither figure is sensitive to
// outliers.
struct Timing {
  double median_ms = 0.0;
  double spread_ms = 0.0;

  bool operator==(const Timing&) const = default;
};

// The quartiles are interpolated linearly between order statistics; the result is absent without a sample.
std::optional<Timing> summarise(std::vector<double> milliseconds);

}  // namespace penumbra::study
