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

// Decimals at which the last digit of a half width stands: its second digit up to 35, else its first (the
// rule of the Particle Data Group's reviews): 0.031 has 3, 0.0042 has 3, 0.0996 (0.10) has 2, 12 has none.
int decimals_of(double half, int most_decimals) {
  const double exponent = std::floor(std::log10(half));
  const double digits = half / std::pow(10.0, exponent);  // [1, 10)
  const bool two = digits < 3.55;
  const bool next = digits >= 9.5;  // rounds to 10
  const auto decimals = static_cast<int>((two || next ? 1.0 : 0.0) - exponent - (next ? 1.0 : 0.0));
  return std::clamp(decimals, 0, most_decimals);
}

// Three significant digits, but none that are nothing: "4", not "4.00".
std::string plain(double value, int most_decimals) {
  if (value == std::round(value)) return fmt::format("{:.0f}", value);
  const auto decimals = 2 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fmt::format("{:.{}f}", value, std::clamp(decimals, 0, std::min(3, most_decimals)));
}

std::string text_of(const std::optional<Estimate>& estimate, double scale, int most_decimals,
                    bool with_half) {
  if (!estimate) return "–";
  const double value = scale * estimate->value;
  const double half = half_width(*estimate, scale);
  if (half < 0.5 * std::pow(10.0, -most_decimals)) return plain(value, most_decimals);
  const int decimals = decimals_of(half, most_decimals);
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return with_half ? text + fmt::format(" ± {:.{}f}", half, decimals) : text;
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

}  // namespace penumbra::study
