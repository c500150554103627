#include "parameters/disk_generator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>

#include "parameters/disk_quality.h"

namespace penumbra::parameters {

namespace {

constexpr int kStarts = 96;
constexpr int kSteps = 80;
constexpr double kMomentum = 0.95;
constexpr double kStepSize = 0.3;

using Points = std::vector<glm::dvec2>;

// The generator is PCG-XSH-RR 64/32 (O'Neill 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2 + 1) { next(); }

  // Returns a uniform number in [-1, 1), on a grid of 2^-31.
  double signed_unit() { return static_cast<double>(next()) * (1.0 / 2147483648.0) - 1.0; }

 private:
  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + 1442695040888963407ULL;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto turn = static_cast<std::uint32_t>(old >> 59U);
    return (mixed >> turn) | (mixed << ((32U - turn) & 31U));
  }

  std::uint64_t state_;
};

glm::dvec2 random_in_disk(Random& random) {
  for (;;) {
    const double x = random.signed_unit();
    const double y = random.signed_unit();
    if (x * x + y * y < 1.0) return {x, y};
  }
}

double square(const glm::dvec2& v) {
  return v.x * v.x + v.y * v.y;
}

Points throw_darts(int count, Random& random) {
  Points points;
  for (int i = 0; i < count; ++i) {
    glm::dvec2 best(0.0);
    double best_gap = -1.0;
    for (int candidate = 0; candidate < 10 * (i + 1); ++candidate) {
      const glm::dvec2 point = random_in_disk(random);
      double gap = 4.0;
      for (const glm::dvec2& other : points) gap = std::min(gap, square(point - other));
      if (gap > best_gap) {
        best_gap = gap;
        best = point;
      }
    }
    points.push_back(best);
  }
  return points;
}

// Returns N times the gradient of the error's bracket in disk_quality.h.
Points gradient(const Points& points) {
  const double weight = 1.0 / static_cast<double>(points.size());
  Points result;
  for (const glm::dvec2& point : points) {
    result.push_back(point * (2.0 * distance_to_disk(square(point)).slope));  // dg/dp = 2 p dg/dm
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec2 apart = points[i] - points[j];
      const double distance = std::sqrt(square(apart) + 1e-18);
      const glm::dvec2 push = apart * (weight / distance);
      result[i] -= push;
      result[j] += push;
    }
  }
  return result;
}

void descend(Points& points) {
  Points velocity(points.size(), glm::dvec2(0.0));
  for (int step = 0; step < kSteps; ++step) {
    const Points slope = gradient(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      velocity[i] = velocity[i] * kMomentum - slope[i] * kStepSize;
      points[i] += velocity[i];
      const double length = std::sqrt(square(points[i]));
      if (length > 0.9999) {  // no point leaves the disk
        points[i] *= 0.9999 / length;
        velocity[i] = glm::dvec2(0.0);
      }
    }
  }
}

// The order is greedy: appending p to a prefix of n changes the error's bracket, times (n + 1)^2, by (n + 1)
// (G + g(p)) - (B + sum |p - q|), where G and B are the prefix's own sums.
DiskPoints ordered(const DiskPoints& rounded) {
  Points points(rounded.begin(), rounded.end());
  std::vector<double> to_prefix(points.size(), 0.0);
  double disk_sum = 0.0;
  double pair_sum = 0.0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    std::size_t best = n;
    double best_error = HUGE_VAL;
    const double size = static_cast<double>(n) + 1.0;
    for (std::size_t i = n; i < points.size(); ++i) {
      const double g = distance_to_disk(square(points[i])).mean;
      const double error = (disk_sum + g) * size - (pair_sum + to_prefix[i]);
      if (error < best_error) {
        best_error = error;
        best = i;
      }
    }
    std::swap(points[n], points[best]);
    std::swap(to_prefix[n], to_prefix[best]);
    disk_sum += distance_to_disk(square(points[n])).mean;
    pair_sum += to_prefix[n];
    for (std::size_t i = n + 1; i < points.size(); ++i) {
      to_prefix[i] += std::sqrt(square(points[i] - points[n]));
    }
  }
  return {points.begin(), points.end()};
}

}  // namespace

DiskPoints generate_poisson_disk(int count, const std::function<void()>& before_start) {
  DiskPoints best;
  double best_error = HUGE_VAL;
  for (int start = 0; start < kStarts; ++start) {
    if (before_start) before_start();
    Random random(static_cast<std::uint64_t>(count) * 1000 + static_cast<std::uint64_t>(start));
    Points points = throw_darts(count, random);
    descend(points);
    const DiskPoints rounded(points.begin(), points.end());
    const DiskQuality quality = disk_quality(rounded);
    const double error = quality.half_plane_rmse * quality.star_discrepancy;
    if (error < best_error) {
      best_error = error;
      best = rounded;
    }
  }
  return ordered(best);
}

}  // namespace penumbra::parameters
