#include "study/texel/geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace penumbra::texel {
namespace {

constexpr double kPi = std::numbers::pi;

// The antiderivative of the share by the distance, as parts of the radius: 0 at -1, 1 at 1.
double antiderivative(double t) {
  if (t <= -1.0) return 0.0;
  if (t >= 1.0) return t;
  const double root = std::sqrt(1.0 - t * t);
  return 0.5 * t + (t * std::asin(t) + root - root * root * root / 3.0) / kPi;
}

// Area of the unit disc to the left of x and below y.
double area_of_corner(double x, double y) {
  const auto strip = [](double at) {
    return at * std::sqrt(1.0 - at * at) + std::asin(at);
  };  // 2 x its area from 0
  x = std::clamp(x, -1.0, 1.0);
  y = std::clamp(y, -1.0, 1.0);
  if (x == -1.0 || y == -1.0) return 0.0;
  // Columns left of the disc's crossings with the line are all or nothing; those between go up to the line.
  const double half = std::sqrt(1.0 - y * y);
  const auto columns = [&](double from, double to, double share) {  // share of a column's height
    to = std::min(to, x);
    return to > from ? share * (strip(to) - strip(from)) : 0.0;
  };
  const double beside = y > 0.0 ? 1.0 : 0.0;
  const double middle = std::min(half, x);
  double area = columns(-1.0, -half, beside) + columns(half, 1.0, beside);
  if (middle > -half) area += 0.5 * (strip(middle) - strip(-half)) + y * (middle + half);
  return area;
}

}  // namespace

int Random::poisson(double mean) {
  int count = 0;
  // The sum is in parts, so that no exponential is too small.
  for (double left = mean; left > 0.0; left -= 16.0) {
    const double limit = std::exp(-std::min(left, 16.0));
    for (double product = chance(); product > limit; product *= chance()) ++count;
  }
  return count;
}

double covered_by_half_plane(double inside, double radius) {
  const double t = inside / radius;
  if (t <= -1.0) return 0.0;
  if (t >= 1.0) return 1.0;
  return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / kPi;
}

double mean_covered_by_half_plane(double inside, double reach, double radius) {
  const double half = reach / radius;
  if (half < 1e-4) return covered_by_half_plane(inside, radius);
  const double t = inside / radius;
  return (antiderivative(t + half) - antiderivative(t - half)) / (2.0 * half);
}

std::array<double, 16> shares_of_texels(Point centre, double radius) {
  std::array<double, 25> corners{};
  for (int i = 0; i < 25; ++i)
    corners[i] = area_of_corner((i % 5 - 2 - centre.x) / radius, (i / 5 - 2 - centre.y) / radius) / kPi;
  std::array<double, 16> shares{};
  for (int i = 0; i < 16; ++i) {
    const int corner = i % 4 + 5 * (i / 4);
    shares[i] = corners[corner + 6] - corners[corner + 5] - corners[corner + 1] + corners[corner];
  }
  return shares;
}

bool Ellipse::contains(Point point) const {
  const double x = point.x - centre.x, y = point.y - centre.y;
  const double along = (x * axis.x + y * axis.y) / major, across = (y * axis.x - x * axis.y) / minor;
  return along * along + across * across < 1.0;
}

bool Ellipse::interval(double y, double& from, double& to) const {
  const double dy = y - centre.y;
  const double p = axis.x / major, q = -axis.y / minor;
  const double u = dy * axis.y / major, v = dy * axis.x / minor;
  // The roots are those of (p x + u)^2 + (q x + v)^2 = 1.
  const double a = p * p + q * q, b = p * u + q * v, c = u * u + v * v - 1.0;
  const double root = b * b - a * c;
  if (!(root > 0.0)) return false;
  from = centre.x + (-b - std::sqrt(root)) / a;
  to = centre.x + (-b + std::sqrt(root)) / a;
  return true;
}

double covered_by_ellipses(Point centre, double radius, const std::vector<Ellipse>& ellipses, int lines) {
  std::vector<const Ellipse*> near;
  for (const Ellipse& one : ellipses) {
    const double reach = radius + one.major, x = one.centre.x - centre.x, y = one.centre.y - centre.y;
    if (x * x + y * y < reach * reach) near.push_back(&one);
  }
  if (near.empty()) return 0.0;
  std::vector<std::pair<double, double>> parts;
  double sum = 0.0;
  for (int k = 0; k < lines; ++k) {
    const double angle = (k + 0.5) * kPi / lines;
    const double half = radius * std::sin(angle);
    parts.clear();
    for (const Ellipse* one : near) {
      double from = 0.0, to = 0.0;
      if (!one->interval(centre.y + radius * std::cos(angle), from, to)) continue;
      from = std::max(from - centre.x, -half);
      to = std::min(to - centre.x, half);
      if (to > from) parts.emplace_back(from, to);
    }
    std::sort(parts.begin(), parts.end());
    double covered = 0.0, end = -half;
    for (const auto& [from, to] : parts) {
      if (to > end) covered += to - std::max(from, end);
      end = std::max(end, to);
    }
    sum += half * covered;
  }
  return sum / (lines * radius * radius);
}

}  // namespace penumbra::texel
