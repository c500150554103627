// A figure as text, with no more digits than its interval holds: "0.147 ± 0.031".
//
// The half width is the longer side of the 95 % interval, to one or two digits; the figure ends where they
// end. An interval that ends at a bound, 0 or 1, is not symmetric and stands with both ends: "0.07 [0,
// 0.17]". A figure whose interval has no width (a constant, or a rate of exactly 0) stands alone, with three
// significant digits.
#pragma once

#include <optional>
#include <string>

#include "study/interval.h"

namespace penumbra::study {

struct Estimate {
  double value = 0.0;
  std::optional<Interval> interval;  // absent: not known

  bool operator==(const Estimate&) const = default;
};

// scale is applied first: 100 for percent. Never more than most_decimals. An absent figure is "–".
std::string figure_text(const std::optional<Estimate>& estimate, double scale = 1.0, int most_decimals = 4);

// The same without its interval, for places whose intervals stand elsewhere.
std::string figure_text_alone(const std::optional<Estimate>& estimate, double scale = 1.0,
                              int most_decimals = 4);

// Fetches per pixel: a tenth is the finest that tells techniques apart.
std::string fetches_text(const std::optional<Estimate>& fetches);

}  // namespace penumbra::study
