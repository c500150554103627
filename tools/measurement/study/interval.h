// How far a figure holds: 95 % intervals, by the bootstrap (Efron & Tibshirani, "An Introduction to the
// Bootstrap", 1993).
//
// Within a picture, neighbouring pixels err alike, so whole blocks of pixels are drawn, not pixels (the block
// bootstrap; Davison & Hinkley, "Bootstrap Methods and their Application", 1997, section 8.3). Over scenes it
// has two levels: scenes are drawn, and within each scene its figure with that scene's own standard error.
//
// The replicates' standard deviation is the figure's standard error; the interval reaches Student's t of them
// to both sides, for as many degrees of freedom as blocks or scenes stand behind the figure, less one.
// Percentiles of the replicates would end at the smallest and the largest scene, and hold the truth too
// seldom for a few (Hesterberg, "What Teachers Should Know About the Bootstrap", The American Statistician
// 69, 2015).
//
// Guarantees: the same input gives the same bytes on every run; an interval holds its own figure.
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

// What one block of pixels adds to a figure: the figure is the sum of sums over the sum of counts.
struct BlockSums {
  double sum = 0.0;
  double count = 0.0;
};

enum class Figure { mean, root_of_mean };

// Of the figure over these blocks, within [0, most]. Blocks without a count take no part; absent when fewer
// than two do.
std::optional<Interval> block_interval(std::span<const BlockSums> blocks, Figure figure, double most);

// One scene's figure, and how sure it is.
struct SceneFigure {
  double value = 0.0;
  double standard_error = 0.0;  // 0 where it is not known
};

// Of the mean over scenes, each weighing the same, within [least, most]. Of one scene: by its
// standard error alone, absent where that is 0. Absent without scenes.
std::optional<Interval> mean_interval(std::span<const SceneFigure> scenes, double least, double most);

}  // namespace penumbra::study
