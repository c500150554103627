#include "study/results.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace penumbra::study {
namespace {

double quantile(const std::vector<double>& sorted, double fraction) {
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

auto members(const MeasuredFrame& frame) {
  const parameters::Camera& camera = frame.camera;
  return std::tie(frame.scene, frame.light_degrees, frame.sun_direction, frame.width, frame.height,
                  frame.shadow_distance_metres, camera.position, camera.forward, camera.up,
                  camera.fov_y_degrees, camera.near_plane, camera.far_plane);
}

}  // namespace

std::optional<Timing> summarise(std::vector<double> milliseconds) {
  if (milliseconds.empty()) return std::nullopt;
  std::sort(milliseconds.begin(), milliseconds.end());
  return Timing{quantile(milliseconds, 0.5), quantile(milliseconds, 0.75) - quantile(milliseconds, 0.25)};
}

bool MeasuredFrame::operator==(const MeasuredFrame& other) const {
  return members(*this) == members(other);
}

bool has_invalid_values(const Results& results) {
  return std::any_of(results.records.begin(), results.records.end(),
                     [](const Record& record) { return record.metrics.invalid > 0; });
}

std::string_view time_kind(const Results& results) {
  return results.is_software ? "CPU time" : "GPU time";
}

}  // namespace penumbra::study
