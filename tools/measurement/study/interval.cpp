#include "study/interval.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace penumbra::study {
namespace {

constexpr int kFetchDecimals = 1;

double half_width(const Estimate& estimate, double scale) {
  if (!estimate.interval) return 0.0;
  return scale * std::max(estimate.value - estimate.interval->low, estimate.interval->high - estimate.value);
}

// Returns the number of decimals of a half width: its second digit up to 35, else its first (the rule of the
// Particle Data Group's reviews): 0.031 has 3, 0.0042 has 3, 0.0996 (0.10) has 2, 12 has none.
int decimals_of(double half, int most_decimals) {
  const double exponent = std::floor(std::log10(half));
  const double digits = half / std::pow(10.0, exponent);  // [1, 10)
  const bool two = digits < 3.55;
  const bool next = digits >= 9.5;  // rounds to 10
  const auto decimals = static_cast<int>((two || next ? 1.0 : 0.0) - exponent - (next ? 1.0 : 0.0));
  return std::clamp(decimals, 0, most_decimals);
}

// Returns three significant digits without trailing zeros: "4", not "4.00".
std::string plain(double value, int most_decimals) {
  if (value == std::round(value)) return fmt::format("{:.0f}", value);
  const auto decimals = 2 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fmt::format("{:.{}f}", value, std::clamp(decimals, 0, std::min(3, most_decimals)));
}

// Returns whether the interval was clipped at 0 or 1. One that ends there by coincidence is symmetric.
bool is_cut_off(const Interval& interval, double value) {
  const double below = value - interval.low;
  const double above = interval.high - value;
  const bool symmetric = std::abs(below - above) <= 1e-6 * std::max(below, above);
  return (interval.low == 0.0 || interval.high == 1.0) && !symmetric;
}

// An end of an interval; a bound has no decimals: "0", not "0.00".
std::string end_text(double end, int decimals) {
  return end == std::round(end) ? fmt::format("{:.0f}", end) : fmt::format("{:.{}f}", end, decimals);
}

constexpr std::size_t kBlockReplicates = 1000;
constexpr double kNormalQuantile = 1.959963984540054;  // 97.5 %

// The standard's engine is the same everywhere, while its distributions are not.
class Draws {
 public:
  std::size_t index(std::size_t count) {
    return static_cast<std::size_t>((static_cast<std::uint64_t>(engine_()) * count) >> 32U);
  }

 private:
  std::mt19937 engine_{13};
};

// Returns the 97.5 % quantile of Student's t: exact for one and two degrees of freedom, else the expansion in
// 1/degrees of Abramowitz & Stegun 26.7.5, whose error from three degrees on is below 1 %.
double student_quantile(double degrees) {
  if (degrees < 1.5) return 12.706204736;
  if (degrees < 2.5) return 4.302652730;
  const double z = kNormalQuantile;
  const double z2 = z * z;
  const double g1 = z * (z2 + 1.0) / 4.0;
  const double g2 = z * ((5.0 * z2 + 16.0) * z2 + 3.0) / 96.0;
  const double g3 = z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / 384.0;
  return z + (g1 + (g2 + g3 / degrees) / degrees) / degrees;
}

double standard_deviation(const std::vector<double>& values) {
  double mean = 0.0;
  for (const double value : values) mean += value;
  mean /= static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

// Returns the interval around a figure that is derived from `count` independent samples.
Interval interval_of(double figure, double error, std::size_t count, double least, double most) {
  const double reach = student_quantile(static_cast<double>(count) - 1.0) * error;
  return {std::clamp(figure - reach, least, most), std::clamp(figure + reach, least, most), error};
}

// Resampling with replacement underestimates the variance by the factor (count - 1) / count.
double unbiased(double deviation, std::size_t count) {
  const auto n = static_cast<double>(count);
  return std::sqrt(n / (n - 1.0)) * deviation;
}

double value_of(const BlockSums& total, Figure figure) {
  const double mean = total.sum / total.count;
  return figure == Figure::mean ? mean : std::sqrt(mean);
}

void add(BlockSums& total, const BlockSums& block) {
  total.sum += block.sum;
  total.count += block.count;
}

}  // namespace

std::optional<Interval> block_interval(std::span<const BlockSums> blocks, Figure figure, double most) {
  std::vector<BlockSums> counted;
  BlockSums all;
  for (const BlockSums& block : blocks) {
    if (!(block.count > 0.0)) continue;
    counted.push_back(block);
    add(all, block);
  }
  if (counted.size() < 2) return std::nullopt;
  Draws draws;
  std::vector<double> replicates(kBlockReplicates);
  for (double& replicate : replicates) {
    BlockSums total;
    for (std::size_t k = 0; k < counted.size(); ++k) add(total, counted[draws.index(counted.size())]);
    replicate = value_of(total, figure);
  }
  const double error = unbiased(standard_deviation(replicates), counted.size());
  return interval_of(value_of(all, figure), error, counted.size(), 0.0, most);
}

std::optional<Interval> mean_interval(std::span<const SceneFigure> scenes, double least, double most) {
  if (scenes.empty()) return std::nullopt;
  const auto count = static_cast<double>(scenes.size());
  double mean = 0.0;
  for (const SceneFigure& scene : scenes) mean += scene.value / count;
  if (scenes.size() == 1) {
    const double error = scenes.front().standard_error;
    if (!(error > 0.0)) return std::nullopt;
    return Interval{std::clamp(mean - kNormalQuantile * error, least, most),
                    std::clamp(mean + kNormalQuantile * error, least, most), error};
  }
  // A resampled mean is a sum of independent draws, so its variance is known without drawing any.
  double squares = 0.0;
  for (const SceneFigure& scene : scenes)
    squares += (scene.value - mean) * (scene.value - mean) + scene.standard_error * scene.standard_error;
  return interval_of(mean, unbiased(std::sqrt(squares) / count, scenes.size()), scenes.size(), least, most);
}

std::string figure_text(const std::optional<Estimate>& estimate, double scale, int most_decimals) {
  if (!estimate) return "–";
  const double value = scale * estimate->value;
  const double half = half_width(*estimate, scale);
  if (half < 0.5 * std::pow(10.0, -most_decimals)) return plain(value, most_decimals);
  const int decimals = decimals_of(half, most_decimals);
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  if (!is_cut_off(*estimate->interval, estimate->value))
    return text + fmt::format(" ± {:.{}f}", half, decimals);
  return text + fmt::format(" [{}, {}]", end_text(scale * estimate->interval->low, decimals),
                            end_text(scale * estimate->interval->high, decimals));
}

std::string fetches_text(const std::optional<Estimate>& fetches) {
  return figure_text(fetches, 1.0, kFetchDecimals);
}

std::string operations_text(const std::optional<Estimate>& operations) {
  return figure_text(operations, 1.0, 0);
}

}  // namespace penumbra::study
