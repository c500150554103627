#include "study/figure_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

std::string text_of(const std::optional<Estimate>& estimate, double scale, int most_decimals,
                    bool with_interval) {
  if (!estimate) return "–";
  const double value = scale * estimate->value;
  const double half = half_width(*estimate, scale);
  if (half < 0.5 * std::pow(10.0, -most_decimals)) return plain(value, most_decimals);
  const int decimals = decimals_of(half, most_decimals);
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  if (!with_interval) return text;
  if (!is_cut_off(*estimate->interval, estimate->value))
    return text + fmt::format(" ± {:.{}f}", half, decimals);
  return text + fmt::format(" [{}, {}]", end_text(scale * estimate->interval->low, decimals),
                            end_text(scale * estimate->interval->high, decimals));
}

}  // namespace

std::string figure_text(const std::optional<Estimate>& estimate, double scale, int most_decimals) {
  return text_of(estimate, scale, most_decimals, true);
}

std::string figure_text_alone(const std::optional<Estimate>& estimate, double scale, int most_decimals) {
  return text_of(estimate, scale, most_decimals, false);
}

std::string fetches_text(const std::optional<Estimate>& fetches) {
  return figure_text(fetches, 1.0, kFetchDecimals);
}

std::string operations_text(const std::optional<Estimate>& operations) {
  return figure_text(operations, 1.0, 0);
}

}  // namespace penumbra::study
