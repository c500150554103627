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

TEST(DiscSamples, BothHalvesOfEveryPairAreCentredAndUniformByArea) {
  constexpr std::size_t points = 1024;
  const DiscSamples samples(points, 5);
  for (std::size_t pair = 0; pair < DiscSamples::pair_count; ++pair) {
    double x[2] = {};
    double y[2] = {};
    double square[2] = {};
    for (std::size_t point = 0; point < points; ++point) {
      const std::size_t half = point / DiscSamples::half_packet % 2;
      x[half] += samples.x(pair)[point];
      y[half] += samples.y(pair)[point];
      square[half] += std::pow(samples.x(pair)[point], 2) + std::pow(samples.y(pair)[point], 2);
    }
    for (const int half : {0, 1}) {
      EXPECT_NEAR(x[half] / 512, 0.0, 0.005) << "pair " << pair;
      EXPECT_NEAR(y[half] / 512, 0.0, 0.005) << "pair " << pair;
      EXPECT_NEAR(square[half] / 512, 0.5, 0.005) << "pair " << pair;  // mean r^2 of a uniform disc
    }
  }
}

TEST(DiscSamples, APacketStaysInOneCellOfTheDisc) {
  // There are 64 packets of 1024 points. Cells are an eighth of the square's side, and nowhere wider than 0.6
  // on the disc.
  const DiscSamples samples(1024, 5);
  for (std::size_t first = 0; first < 1024; first += 16) {
    for (std::size_t point = first + 1; point < first + 16; ++point) {
      EXPECT_LT(
          std::hypot(samples.x(3)[point] - samples.x(3)[first], samples.y(3)[point] - samples.y(3)[first]),
          0.6)
          << "points " << first << " and " << point;
    }
  }
}

TEST(DiscSamples, SetsDifferFromEachOtherAndRepeatWithTheSeed) {
  const DiscSamples samples(64, 5);
  const DiscSamples again(64, 5);
  const DiscSamples other(64, 6);
  std::set<float> first_points;
  for (std::size_t pair = 0; pair < DiscSamples::pair_count; ++pair) {
    first_points.insert(samples.x(pair)[0]);
    first_points.insert(samples.x(pair)[DiscSamples::half_packet]);
    EXPECT_EQ(samples.x(pair)[3], again.x(pair)[3]);
    EXPECT_NE(samples.x(pair)[3], other.x(pair)[3]);
  }
  EXPECT_EQ(first_points.size(), 2 * DiscSamples::pair_count);
}

TEST(DiscSamples, PixelsDrawEveryPairAndAnglesAllAround) {
  const DiscSamples samples(64, 5);
  std::set<std::size_t> pairs;
  double cosines = 0.0;
  double sines = 0.0;
  for (std::size_t pixel = 0; pixel < 10000; ++pixel) {
    const PixelDraw draw = samples.draw(pixel);
    pairs.insert(draw.pair);
    cosines += std::cos(draw.angle) / 10000.0;
    sines += std::sin(draw.angle) / 10000.0;
  }
  EXPECT_EQ(pairs.size(), DiscSamples::pair_count);
  EXPECT_NEAR(cosines, 0.0, 0.03);  // the bound is four standard deviations
  EXPECT_NEAR(sines, 0.0, 0.03);
}

}  // namespace
}  // namespace penumbra::reference
