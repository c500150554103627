// The error of a shadow technique: its visibility images against ray tracing, and its fetches.
//
// Visibility is 1 where the whole light disc is visible, 0 where none of it is. References (design, contract
// 7):
//   T1  ray-traced area light on the real geometry: the ground truth of all errors here
//   T2  the exhaustive result from the same shadow map: a defined reference, not a bound
//   T3  the technique itself with unlimited samples
// Pixel classes depend only on T1, so that every technique is evaluated on the same pixels:
//   umbra T1 < 0.02, penumbra 0.02 < T1 < 0.98, lit T1 > 0.98.
//
// All sums are in double and run over pixels in row order, then over seeds: the same images give the same
// bits. A figure without any pixel is absent (null in JSON), never 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "study/interval.h"

namespace penumbra::study {

inline constexpr double kUmbraBelow = 0.02;
inline constexpr double kLitAbove = 0.98;
inline constexpr double kLeakAbove = 0.1;
inline constexpr double kFalseShadowBelow = 0.9;

// Every span holds one value per pixel, in the same row order. Pixels whose valid entry is 0 (no receiver)
// are ignored.
struct MeasuredImages {
  std::span<const float> t1;
  std::span<const std::uint8_t> valid;
  std::vector<std::span<const float>> results;          // one image per noise seed, at least one
  std::vector<std::span<const std::uint32_t>> fetches;  // one image per seed, or one for all, or none
  std::span<const float> t2;                            // empty when not computed
  std::span<const float> t3;                            // empty when not computed
  double preprocess_fetches_per_pixel = 0.0;            // by map preparation and passes at lower resolution
  std::span<const std::uint8_t> masked_out;  // 1 where a penumbra mask says "none here"; empty without
  int width = 0;                             // pixels of a row, for intervals; 0: one block and no intervals
};

// A picture is kBlocksAcross square blocks wide, of at least kSmallestBlock pixels a side, from which
// intervals are drawn. The block is a share of the picture, because a larger picture shows the same penumbrae
// wider.
inline constexpr int kBlocksAcross = 32;
inline constexpr int kSmallestBlock = 4;

// The pixels that a penumbra mask skips, as shares.
struct MaskShares {
  double pixels_saved = 0.0;                       // share of all pixels that the mask leaves out
  std::optional<double> penumbra_pixels_missed{};  // share of penumbra pixels that it skips by mistake

  bool operator==(const MaskShares&) const = default;
};

// A signed error over penumbra pixels (and seeds, where the result takes part).
struct ErrorShare {
  double mean = 0.0;
  double rmse = 0.0;

  bool operator==(const ErrorShare&) const = default;
};

// The error by its causes. Per pixel (T2-T1) + (T3-T2) + (result-T3) = result-T1, so the means add up to the
// bias. The RMSEs do not add and do not subtract: the three shares are correlated.
struct ErrorSplit {
  std::optional<ErrorShare> map;        // T2 - T1: the error of the map's resolution and its single layer
  std::optional<ErrorShare> algorithm;  // T3 - T2: the error of the technique's penumbra model
  std::optional<ErrorShare> sampling;   // result - T3: the error of few samples

  bool operator==(const ErrorSplit&) const = default;
};

// The intervals of the figures of the same names; absent where the figure is, or if it depends on one block
// only.
struct MetricIntervals {
  std::optional<Interval> rmse_penumbra;
  std::optional<Interval> rmse_all;
  std::optional<Interval> leak_rate;
  std::optional<Interval> false_shadow_rate;
  std::optional<Interval> fetches_mean;

  bool operator==(const MetricIntervals&) const = default;
};

struct Metrics {
  std::size_t pixels = 0;  // number with a receiver
  std::size_t penumbra_pixels = 0;
  std::size_t seeds = 0;
  std::size_t invalid = 0;  // results (T3 included) that are not finite or outside [0, 1]: a finding;
                            // they enter no other figure
  std::optional<double> rmse_penumbra;  // over penumbra pixels and seeds, against T1
  std::optional<double> rmse_all;       // over all pixels and seeds
  std::optional<double> bias;           // mean of result - T1 over penumbra: > 0 is too bright
  std::optional<double> variance;       // mean over penumbra pixels of the sample variance (n - 1) over seeds
  std::optional<double> p99;            // nearest-rank 99th percentile of |result - T1| in penumbra
  std::optional<double> max_error;      // largest |result - T1| of any pixel and seed
  std::optional<double> leak_rate;      // share of umbra results above 0.1
  std::optional<double> false_shadow_rate;  // share of lit results below 0.9
  std::optional<double> fetches_mean;       // over all pixels
  std::optional<double> fetches_p95;        // nearest-rank
  std::optional<double> fetches_penumbra_mean;
  double preprocess_fetches_per_pixel = 0.0;
  std::optional<MaskShares> mask;  // for techniques with a penumbra mask
  ErrorSplit split;
  MetricIntervals intervals;  // 95 %

  bool operator==(const Metrics&) const = default;
};

// Throws std::invalid_argument when images differ in size, there is no result, or T1 or T2 is outside [0, 1]
// where valid: a broken reference must not become a figure.
Metrics measure(const MeasuredImages& images);

// Shimmer: the flicker of a technique's picture while the camera pans slowly.
//
// The picture moves by one pixel per frame, as with a lens shift: every point of a surface stays on pixel
// centres, the shadow map does not change, and the light on each point does not change. All changes are the
// technique's: noise that is fixed to the screen, or changes with every frame, and grids of its own.

// RMS change of visibility from one frame to the next, at the same points, in penumbra.
struct Shimmer {
  int frames = 0;
  std::optional<double> static_noise;     // noise that is fixed to the screen
  std::optional<double> per_frame_noise;  // noise that changes every frame

  bool operator==(const Shimmer&) const = default;
};

// frames[k] is the picture moved k columns to the left; t1 and valid are those of frames[0]. Points that
// leave the picture are ignored. The result is absent without a point in penumbra.
std::optional<double> shimmer_of(const std::vector<std::vector<float>>& frames, int width,
                                 std::span<const float> t1, std::span<const std::uint8_t> valid);

// The seam between cascades: the change of a technique's error where neighbouring pixels read different ones.
//
// The texels' size changes from one cascade to the next, and with it a filter's error. The eye sees a change
// along a line, not noise: so changes are first averaged along the border, in blocks of kSeamBlock pixels.
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

// The step of a technique's error at the borders of the groups of pixels that its kernels compute together,
// beside the step between other neighbours. What a group shares shows as blocks, where the ratio of both is
// above 1.
inline constexpr int kGroupPixels = 8;  // pixels, each way

struct GroupStep {
  std::size_t pairs = 0;  // pairs of neighbouring penumbra pixels of one cascade, one in each of two groups
  // RMS of the difference of error of these pairs, and of those within groups.
  std::optional<double> across;
  std::optional<double> inside;

  bool operator==(const GroupStep&) const = default;
};

// Throws std::invalid_argument for images of different sizes.
GroupStep group_step_of(const SeamImages& images);

}  // namespace penumbra::study
