// A figure as text, with no more digits than its interval justifies: "0.147 ± 0.031".
//
// The half width is the longer side of the 95 % interval, rounded to one or two digits; the figure has the
// same decimals. An interval that ends at a bound, 0 or 1, is not symmetric and is printed with both ends:
// "0.07 [0, 0.17]". A figure whose interval has no width (a constant, or a rate of exactly 0) is printed
// alone, with three significant digits.
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

// `scale` is applied first: 100 for percent. The text never has more than most_decimals. An absent figure is
// "–".
std::string figure_text(const std::optional<Estimate>& estimate, double scale = 1.0, int most_decimals = 4);

// Returns the same without its interval, where the interval is shown elsewhere.
std::string figure_text_alone(const std::optional<Estimate>& estimate, double scale = 1.0,
                              int most_decimals = 4);

// Returns fetches per pixel: a tenth is the finest that distinguishes techniques.
std::string fetches_text(const std::optional<Estimate>& fetches);

// Returns operations per pixel as a whole number.
std::string operations_text(const std::optional<Estimate>& operations);

}  // namespace penumbra::study
