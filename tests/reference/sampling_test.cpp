#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "reference/disc_samples.h"

namespace penumbra::reference {
namespace {

TEST(ScrambledSobol, EveryElementaryIntervalHoldsOnePoint) {
  constexpr int log_points = 8;
  for (const std::uint64_t seed : {1U, 2U, 77U}) {
    for (int log_columns = 0; log_columns <= log_points; ++log_columns) {
      const double columns = std::ldexp(1.0, log_columns);
      const double rows = std::ldexp(1.0, log_points - log_columns);
      std::set<std::pair<int, int>> cells;
      for (std::uint32_t index = 0; index < 256; ++index) {
        const glm::dvec2 point = scrambled_sobol(index, seed);
        cells.emplace(static_cast<int>(point.x * columns), static_cast<int>(point.y * rows));
      }
      EXPECT_EQ(cells.size(), 256U) << "seed " << seed << ", " << columns << " x " << rows;
    }
  }
}

TEST(ConcentricDisc, KeepsAreasInProportion) {
  // A disc about the centre holds its share of the area: radius r comes from the square of side r.
  constexpr int side = 400;
  for (const double radius : {0.25, 0.5, 0.9}) {
    int inside = 0;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const glm::dvec2 point = concentric_disc({(x + 0.5) / side, (y + 0.5) / side});
        ASSERT_LE(glm::length(point), 1.0);
        if (glm::length(point) < radius) ++inside;
      }
    }
    EXPECT_NEAR(static_cast<double>(inside) / (side * side), radius * radius, 0.005) << "radius " << radius;
  }
}

TEST(DiscSamples, AreCentredAndUniformByAreaInEverySet) {
  const DiscSamples samples(512, 5);
  for (std::size_t set = 0; set < DiscSamples::set_count; ++set) {
    double x = 0.0;
    double y = 0.0;
    double square = 0.0;
    for (std::size_t point = 0; point < samples.points_per_set(); ++point) {
      x += samples.x(set)[point];
      y += samples.y(set)[point];
      square += std::pow(samples.x(set)[point], 2) + std::pow(samples.y(set)[point], 2);
    }
    EXPECT_NEAR(x / 512, 0.0, 0.005) << "set " << set;
    EXPECT_NEAR(y / 512, 0.0, 0.005) << "set " << set;
    EXPECT_NEAR(square / 512, 0.5, 0.005) << "set " << set;  // mean r^2 of a uniform disc
  }
}

TEST(DiscSamples, SetsDifferFromEachOtherAndRepeatWithTheSeed) {
  const DiscSamples samples(64, 5);
  const DiscSamples again(64, 5);
  const DiscSamples other(64, 6);
  std::set<float> first_points;
  for (std::size_t set = 0; set < DiscSamples::set_count; ++set) {
    first_points.insert(samples.x(set)[0]);
    EXPECT_EQ(samples.x(set)[3], again.x(set)[3]);
    EXPECT_NE(samples.x(set)[3], other.x(set)[3]);
  }
  EXPECT_EQ(first_points.size(), DiscSamples::set_count);
}

}  // namespace
}  // namespace penumbra::reference
