// Compares the closed form over cells and the pyramid with slopes to points along the line, one by one.
#include "bake/horizon_angles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "bake/made_fields.h"

namespace penumbra::bake {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool inside(const Area& area, glm::dvec2 at) {
  const glm::dvec2 far_corner = area.corner + area.size;
  return at.x >= area.corner.x && at.y >= area.corner.y && at.x <= far_corner.x && at.y <= far_corner.y;
}

// The steepest slope to so many points, evenly spread from `nearest` to the far end of the area.
double steepest_point(const HeightField& field, glm::dvec2 from, double height, glm::dvec2 direction,
                      double nearest, int points) {
  const double reach = std::hypot(field.area.size.x, field.area.size.y) + std::hypot(from.x, from.y);
  double steepest = -kInfinity;
  for (int i = 0; i <= points; ++i) {
    const double metres = nearest + (reach - nearest) * i / points;
    const glm::dvec2 at = from + direction * metres;
    if (inside(field.area, at)) steepest = std::max(steepest, (field.height(at) - height) / metres);
  }
  return steepest;
}

TEST(HorizonSearch, FindsWhatMarchingFinds) {
  std::mt19937 bits(7);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits()) * 0x1p-32;
  };
  constexpr int kPoints = 40'000;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const Area area{{between(-50.0, 50.0), between(-50.0, 50.0)}, {between(20.0, 90.0), between(20.0, 90.0)}};
    const HeightField field =
        rough_field(static_cast<int>(between(2.0, 60.0)), static_cast<int>(between(2.0, 60.0)), area, seed);
    const HorizonSearch search(field);
    for (int i = 0; i < 60; ++i) {
      const glm::dvec2 from = area.corner + area.size * glm::dvec2(between(0.0, 1.0), between(0.0, 1.0));
      const double azimuth = i % 4 == 0 ? i * std::numbers::pi / 8.0 : between(0.0, 2.0 * std::numbers::pi);
      const glm::dvec2 direction(std::sin(azimuth), std::cos(azimuth));
      const double nearest = i % 3 == 0 ? between(0.1, 10.0) : 0.05;
      const double height = field.height(from) + (i % 2 == 0 ? 0.0 : between(-1.0, 3.0));
      const double found = search.steepest(from, height, direction, nearest);
      const double marched = steepest_point(field, from, height, direction, nearest, kPoints);
      // The closed form is less by no more than a step of 1e-7 cells over an edge can cost; marching misses
      // at most what the slope changes over one of its steps.
      ASSERT_GE(found, marched - 1e-6 * (1.0 + std::abs(marched))) << "seed " << seed << ", case " << i;
      if (marched == -kInfinity) continue;
      ASSERT_NEAR(found, marched, 0.01 + 0.01 * std::abs(marched)) << "seed " << seed << ", case " << i;
    }
  }
}

// Within a cell that bends downwards along its diagonal the steepest point is inside of the cell.
TEST(HorizonSearch, FindsTheTopOfASaddleWithinACell) {
  const HeightField field{2, 2, {{0.0, 0.0}, {1.0, 1.0}}, {0.0F, 1.0F, 1.0F, 0.0F}};
  const HorizonSearch search(field);
  // Along the diagonal, at u = t / sqrt(2), the surface is 2 u (1 - u). From a height of 0.1 the slope (2 u
  // (1 - u) - 0.1) / t is largest where 2 u^2 = 0.1.
  const glm::dvec2 diagonal = glm::dvec2(1.0, 1.0) / std::sqrt(2.0);
  const double u = std::sqrt(0.05);
  const double expected = (2.0 * u * (1.0 - u) - 0.1) / (u * std::sqrt(2.0));
  EXPECT_NEAR(search.steepest({0.0, 0.0}, 0.1, diagonal), expected, 1e-12);
}

TEST(HorizonSearch, SeesAWallFromOutsideAndNothingBehindIt) {
  const auto wall = [](glm::dvec2 at) { return at.x > 4.9 ? 7.0 : 0.0; };
  const HeightField field = made_field(11, 11, {{0.0, 0.0}, {10.0, 10.0}}, wall);
  const HorizonSearch search(field);
  EXPECT_NEAR(search.steepest({-5.0, 3.0}, 0.0, {1.0, 0.0}), 7.0 / 10.0, 1e-12);
  EXPECT_NEAR(search.steepest({0.0, 3.0}, 0.0, {1.0, 0.0}), 7.0 / 5.0, 1e-12);
  // The ground counts from 7 m on.
  EXPECT_NEAR(search.steepest({0.0, 3.0}, 0.0, {1.0, 0.0}, 7.0), 1.0, 1e-12);
  EXPECT_EQ(search.steepest({-5.0, 3.0}, 0.0, {-1.0, 0.0}), -kInfinity);
  EXPECT_EQ(search.steepest({-5.0, 30.0}, 0.0, {1.0, 0.0}), -kInfinity);
  EXPECT_LT(search.steepest({0.0, 3.0}, 20.0, {1.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace penumbra::bake
