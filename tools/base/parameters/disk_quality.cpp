#include "parameters/disk_quality.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace penumbra::parameters {

namespace {

using std::numbers::pi;

double radial_deviation(std::span<const glm::dvec2> points) {
  std::vector<double> areas;
  for (const glm::dvec2& point : points) areas.push_back(glm::dot(point, point));
  std::sort(areas.begin(), areas.end());
  const auto count = static_cast<double>(points.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const auto before = static_cast<double>(i);
    worst =
        std::max({worst, std::abs(areas[i] - before / count), std::abs((before + 1.0) / count - areas[i])});
  }
  return worst;
}

// A box can be extreme only if its sides touch points (or 1): an open one for too few points, a closed one
// for too many.
double star_discrepancy(std::span<const glm::dvec2> points) {
  std::vector<glm::dvec2> square;
  std::vector<double> xs{1.0};
  std::vector<double> ys{1.0};
  for (const glm::dvec2& point : points) {
    square.push_back(square_from_disk(point));
    xs.push_back(square.back().x);
    ys.push_back(square.back().y);
  }
  const auto count = static_cast<double>(points.size());
  double worst = 0.0;
  for (const double a : xs) {
    for (const double b : ys) {
      int open = 0;
      int closed = 0;
      for (const glm::dvec2& p : square) {
        open += p.x < a && p.y < b ? 1 : 0;
        closed += p.x <= a && p.y <= b ? 1 : 0;
      }
      worst = std::max({worst, a * b - open / count, closed / count - a * b});
    }
  }
  return worst;
}

double smallest_distance(std::span<const glm::dvec2> points) {
  double smallest = 2.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) smallest = std::min(smallest, glm::distance(points[i], points[j]));
  }
  return smallest;
}

}  // namespace

// K and E by the arithmetic-geometric mean (Abramowitz & Stegun 17.6): K = pi / (2 agm(1, sqrt(1 - m))),
// E = K (1 - s), s = sum 2^(n-1) c_n^2 with c_0^2 = m. s / m is summed directly: K - E would cancel near m =
// 0.
DiskDistance distance_to_disk(double radius_squared) {
  const double m = std::clamp(radius_squared, 0.0, 1.0 - 1e-12);
  double a = 1.0;
  double b = std::sqrt(1.0 - m);
  double power = 0.5;
  double s_over_m = 0.5;
  for (int i = 0; i < 8; ++i) {
    // c_1 = (1 - b) / 2 = m / (2 (1 + b)): the form without cancellation; later c shrink quadratically.
    const double c = i == 0 ? 0.5 * m / (1.0 + b) : 0.5 * (a - b);
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
    power *= 2.0;
    if (m > 0.0) s_over_m += power * (c * (c / m));
  }
  const double k = 0.5 * pi / a;
  const double e = k * (1.0 - s_over_m * m);
  return {4.0 / (9.0 * pi) * ((7.0 + m) * e - 4.0 * (1.0 - m) * k),
          2.0 / (3.0 * pi) * (e + k - k * s_over_m)};
}

glm::dvec2 square_from_disk(const glm::dvec2& point) {
  const double radius = glm::length(point);
  if (radius == 0.0) return {0.5, 0.5};
  // The wedge |angle| <= pi/4 about +x becomes the triangle right of the centre; the others by symmetry.
  const bool steep = std::abs(point.y) > std::abs(point.x);
  const double along = steep ? point.y : point.x;
  const double across = steep ? point.x : point.y;
  const double side = along < 0.0 ? -radius : radius;
  const double other = radius * (4.0 / pi) * std::atan(across / std::abs(along));
  const glm::dvec2 centred = steep ? glm::dvec2(other, side) : glm::dvec2(side, other);
  return glm::clamp(0.5 + 0.5 * centred, 0.0, 1.0);
}

double half_plane_rmse(std::span<const glm::dvec2> points) {
  const auto count = static_cast<double>(points.size());
  double to_disk = 0.0;
  double between = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    to_disk += distance_to_disk(glm::dot(points[i], points[i])).mean;
    for (std::size_t j = 0; j < i; ++j) between += glm::distance(points[i], points[j]);
  }
  const double square = to_disk / count - 64.0 / (45.0 * pi) - between / (count * count);
  return std::sqrt(std::max(square, 0.0) / pi);
}

DiskQuality disk_quality(std::span<const glm::vec2> points) {
  const std::vector<glm::dvec2> exact(points.begin(), points.end());
  glm::dvec2 sum(0.0);
  for (const glm::dvec2& point : exact) sum += point;
  const auto count = static_cast<double>(exact.size());
  return {.centroid = glm::length(sum) / count,
          .radial_deviation = radial_deviation(exact),
          .star_discrepancy = star_discrepancy(exact),
          .half_plane_rmse = half_plane_rmse(exact),
          .spacing = exact.size() < 2 ? 0.0 : smallest_distance(exact) * std::sqrt(count)};
}

}  // namespace penumbra::parameters
