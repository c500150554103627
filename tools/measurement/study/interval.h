// Confidence intervals of figures: 95 %, by the bootstrap (Efron & Tibshirani, "An Introduction to the
// Bootstrap", 1993).
//
// Within a picture, errors of neighbouring pixels are correlated, so blocks of pixels are resampled instead
// of pixels (the block bootstrap; Davison & Hinkley, "Bootstrap Methods and their Application", 1997, section
// 8.3). Over scenes it has two levels: scenes are resampled, and within each scene its figure with that
// scene's own standard error. The variance of such a mean has a closed form, which the draws approach.
//
// The replicates' standard deviation is the figure's standard error; the interval extends by Student's t
// times this error to both sides, with as many degrees of freedom as there are blocks or scenes, less one.
// Percentiles of the replicates would end at the smallest and the largest scene, and contain the true value
// too rarely for few scenes (Hesterberg, "What Teachers Should Know About the Bootstrap", The American
// Statistician 69, 2015).
//
// Guarantees: the same input gives the same bytes on every run; an interval contains its own figure.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace penumbra::study {

struct Interval {
  double low = 0.0;
  double high = 0.0;
  double standard_error = 0.0;

  bool operator==(const Interval&) const = default;
};

// The contribution of a block of pixels to a figure: the figure is the sum of sums over the sum of counts.
struct BlockSums {
  double sum = 0.0;
  double count = 0.0;
};

enum class Figure { mean, root_of_mean };

// Returns the interval of the figure over these blocks, within [0, most]. Blocks without a count are ignored;
// absent if fewer than two remain.
std::optional<Interval> block_interval(std::span<const BlockSums> blocks, Figure figure, double most);

// One scene's figure and its standard error.
struct SceneFigure {
  double value = 0.0;
  double standard_error = 0.0;  // 0 if it is not known
};

// Returns the interval of the mean over scenes, each weighing the same, within [least, most]. For one scene
// it follows from its standard error alone, and is absent where that is 0. It is absent without scenes.
std::optional<Interval> mean_interval(std::span<const SceneFigure> scenes, double least, double most);

// A figure as text, with no more digits than its interval justifies: "0.147 ± 0.031".
//
// The half width is the longer side of the 95 % interval, rounded to one or two digits; the figure has the
// same decimals. An interval that ends at a bound, 0 or 1, is not symmetric and is printed with both ends:
// "0.07 [0, 0.17]". A figure whose interval has no width (a constant, or a rate of exactly 0) is printed
// alone, with three significant digits.
struct Estimate {
  double value = 0.0;
  std::optional<Interval> interval;  // absent: not known

  bool operator==(const Estimate&) const = default;
};

// `scale` is applied first: 100 for percent. The text never has more than most_decimals. An absent figure is
// "–".
std::string figure_text(const std::optional<Estimate>& estimate, double scale = 1.0, int most_decimals = 4);

// Returns fetches per pixel: a tenth is the finest that distinguishes techniques.
std::string fetches_text(const std::optional<Estimate>& fetches);

// Returns operations per pixel as a whole number.
std::string operations_text(const std::optional<Estimate>& operations);

}  // namespace penumbra::study
