#include "study/edge_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "parameters/half_angle.h"

namespace penumbra::study {
namespace {

// The offsets are in 16ths of a pixel.
constexpr std::array<std::array<int, 2>, 2> kTwo{{{4, 4}, {-4, -4}}};
constexpr std::array<std::array<int, 2>, 4> kFour{{{-2, -6}, {6, -2}, {-6, 2}, {2, 6}}};
constexpr std::array<std::array<int, 2>, 8> kEight{
    {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}}};

// These are smaller than what a technique may take for an edge, so that an edge that it does not mark counts
// here.
constexpr double kSmallestPixels = 0.5;  // apart, in pixel footprints
constexpr double kLargestCosine = 0.97;  // cosine of the angle between normals

template <std::size_t count>
std::vector<glm::dvec2> offsets_of(const std::array<std::array<int, 2>, count>& sixteenths) {
  std::vector<glm::dvec2> offsets;
  for (const std::array<int, 2>& place : sixteenths) offsets.emplace_back(place[0] / 16.0, place[1] / 16.0);
  return offsets;
}

// Returns whether two samples of one pixel see different surfaces. `metres` is the width of a pixel per metre
// of distance.
bool differ(const SampleView& a, const SampleView& b, std::size_t pixel, const parameters::Camera& camera,
            double metres) {
  if (a.receivers.triangle[pixel] == b.receivers.triangle[pixel]) return false;
  const glm::dvec3 normal(a.receivers.normal_ws[pixel]);
  const glm::dvec3 other(b.receivers.normal_ws[pixel]);
  if (glm::dot(normal, other) < kLargestCosine) return true;
  const glm::dvec3 at(a.receivers.position_ws[pixel]);
  const glm::dvec3 between = glm::dvec3(b.receivers.position_ws[pixel]) - at;
  const double apart = std::max(std::abs(glm::dot(between, normal)), std::abs(glm::dot(between, other)));
  return apart > kSmallestPixels * metres * glm::distance(at, camera.position);
}

bool all_seen(std::span<const SampleView> samples, std::size_t pixel) {
  return std::all_of(samples.begin(), samples.end(),
                     [pixel](const SampleView& sample) { return sample.traced.valid[pixel] != 0; });
}

}  // namespace

std::vector<glm::dvec2> sample_offsets(int samples) {
  if (samples == 2) return offsets_of(kTwo);
  if (samples == 4) return offsets_of(kFour);
  if (samples == 8) return offsets_of(kEight);
  throw std::invalid_argument("samples are 2, 4 or 8");
}

reference::VisibilityImage edge_reference(std::span<const SampleView> samples,
                                          const parameters::Camera& camera) {
  const reference::VisibilityImage& first = samples.front().traced;
  reference::VisibilityImage mean{first.width, first.height, {}, {}, 0.0, 0};
  mean.visibility.resize(first.visibility.size());
  mean.valid.resize(first.valid.size());
  const double metres = 2.0 * parameters::tan_half(camera.fov_y_degrees) / first.height;
  double squares = 0.0;
  for (const SampleView& sample : samples) {
    squares += sample.traced.noise_floor * sample.traced.noise_floor;
    mean.samples += sample.traced.samples;
  }
  mean.noise_floor = std::sqrt(squares) / static_cast<double>(samples.size());
  for (std::size_t pixel = 0; pixel < mean.valid.size(); ++pixel) {
    double sum = 0.0;
    for (const SampleView& sample : samples) sum += sample.traced.visibility[pixel];
    mean.visibility[pixel] = static_cast<float>(sum / static_cast<double>(samples.size()));
    if (!all_seen(samples, pixel)) continue;
    for (const SampleView& sample : samples.subspan(1))
      if (differ(samples.front(), sample, pixel, camera, metres)) mean.valid[pixel] = 1;
  }
  return mean;
}

}  // namespace penumbra::study
