#include "reference/disc_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "reference/hand_built.h"

namespace penumbra::reference {
namespace {

double covered_share(const DiscPoints::Set& covered) {
  const HalfCounts open = DiscPoints::uncovered(covered);
  return 1.0 - static_cast<double>(open.first + open.second) / DiscPoints::count;
}

// The exact share by integration over x of the heights of the rectangle within the disc.
double exact_share(const DiscRectangle& rectangle) {
  constexpr int steps = 20000;
  const double left = std::max(rectangle.left, -1.0);
  const double right = std::min(rectangle.right, 1.0);
  if (left >= right) return 0.0;
  double area = 0.0;
  for (int step = 0; step < steps; ++step) {
    const double x = left + (right - left) * (step + 0.5) / steps;
    const double chord = std::sqrt(1.0 - x * x);
    area += std::max(0.0, std::min(rectangle.top, chord) - std::max(rectangle.bottom, -chord));
  }
  return area * (right - left) / steps / std::acos(-1.0);
}

const DiscPoints& points() {
  static const DiscPoints made;
  return made;
}

TEST(DiscCoverage, SharesAreWithinTheStatedResolution) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.3, 1.3);
  double squares = 0.0;
  double worst = 0.0;
  constexpr int cases = 400;
  for (int index = 0; index < cases; ++index) {
    DiscRectangle rectangle{place(random), place(random), place(random), place(random)};
    if (rectangle.left > rectangle.right) std::swap(rectangle.left, rectangle.right);
    if (rectangle.bottom > rectangle.top) std::swap(rectangle.bottom, rectangle.top);
    // Half of the rectangles are half-planes.
    if (index % 4 == 0) rectangle.left = -9.0, rectangle.bottom = -9.0, rectangle.top = 9.0;
    if (index % 4 == 1) rectangle.bottom = -9.0, rectangle.left = -9.0, rectangle.right = 9.0;
    DiscPoints::Set covered{};
    points().cover(rectangle, covered);
    const double error = std::abs(covered_share(covered) - exact_share(rectangle));
    squares += error * error;
    worst = std::max(worst, error);
  }
  RecordProperty("rms", std::to_string(std::sqrt(squares / cases)));
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(std::sqrt(squares / cases), 0.002);
  EXPECT_LT(worst, 0.008);
}

TEST(DiscCoverage, UnionCountsOverlapOnce) {
  DiscPoints::Set once{};
  points().cover({-0.3, 0.5, -0.2, 0.6}, once);
  DiscPoints::Set twice = once;
  points().cover({-0.1, 0.4, 0.0, 0.5}, twice);
  EXPECT_EQ(once, twice);
}

TEST(DiscCoverage, TilesOfAGridAddUpToTheWhole) {
  for (const int side : {1, 3, 8, 100}) {
    DiscPoints::Set covered{};
    int sum = 0;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const auto edge = [&](int index) { return -1.0 + 2.0 * index / side; };
        DiscPoints::Set one{};
        const DiscRectangle tile{edge(x), edge(x + 1), edge(y), edge(y + 1)};
        points().cover(tile, one);
        points().cover(tile, covered);
        const HalfCounts open = DiscPoints::uncovered(one);
        sum += DiscPoints::count - open.first - open.second;
      }
    }
    EXPECT_TRUE(DiscPoints::all(covered)) << side;
    EXPECT_EQ(sum, DiscPoints::count) << "no point lies in two tiles of a grid of " << side;
  }
}

TEST(DiscCoverage, RectanglesOffTheDiscAndEmptyOnesCoverNothing) {
  DiscPoints::Set covered{};
  for (const DiscRectangle& rectangle :
       {DiscRectangle{1.0, 2.0, -1.0, 1.0}, DiscRectangle{-3.0, -1.0, -1.0, 1.0},
        DiscRectangle{-1.0, 1.0, 1.0, 7.0}, DiscRectangle{0.2, 0.2, -1.0, 1.0},
        DiscRectangle{0.3, -0.3, -1.0, 1.0}}) {
    points().cover(rectangle, covered);
  }
  EXPECT_EQ(covered, DiscPoints::Set{});
}

}  // namespace
}  // namespace penumbra::reference
