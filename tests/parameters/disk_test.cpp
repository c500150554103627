// Tests the disk tables and their quality figures, the figures against brute force.
#include "parameters/disk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>
#include <sstream>

#include "parameters/disk_generator.h"
#include "parameters/disk_quality.h"
#include "parameters/emit_disks.h"

namespace penumbra::parameters {
namespace {

using std::numbers::pi;

// Share of the disk's area before an edge at t.
double area_before(double t) {
  return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / pi;
}

// The definition of the error, by quadrature: 720 directions, 4000 offsets.
double brute_force_rmse(const DiskPoints& points) {
  double sum = 0.0;
  for (int direction = 0; direction < 720; ++direction) {
    const double angle = 2.0 * pi * direction / 720.0;
    std::vector<double> projections;
    for (const auto& p : points) projections.push_back(p.x * std::cos(angle) + p.y * std::sin(angle));
    std::sort(projections.begin(), projections.end());
    for (int offset = 0; offset < 4000; ++offset) {
      const double t = -1.0 + (offset + 0.5) / 2000.0;
      const auto before = std::lower_bound(projections.begin(), projections.end(), t) - projections.begin();
      const double error = static_cast<double>(before) / static_cast<double>(points.size()) - area_before(t);
      sum += error * error;
    }
  }
  return std::sqrt(sum / (720.0 * 4000.0));
}

TEST(DiskQuality, HalfPlaneErrorIsTheDefinitions) {
  for (const DiskPoints& points : {vogel_disk(1), vogel_disk(5), vogel_disk(16), poisson_disk(25)}) {
    EXPECT_NEAR(disk_quality(points).half_plane_rmse, brute_force_rmse(points), 2e-4);
  }
}

// These are known figures of Vogel disks under random edges and rotations.
TEST(DiskQuality, HalfPlaneErrorOfVogelDisksIsTheKnownOne) {
  const std::pair<int, double> known[] = {{5, .094},  {8, .064},  {12, .048},
                                          {16, .037}, {32, .022}, {64, .013}};
  for (const auto& [count, rmse] : known) {
    EXPECT_NEAR(disk_quality(vogel_disk(count)).half_plane_rmse, rmse, 6e-4) << count;
  }
}

TEST(DiskQuality, DistanceToTheDiskHasItsClosedEnds) {
  EXPECT_NEAR(distance_to_disk(0.0).mean, 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(distance_to_disk(1.0).mean, 32.0 / (9.0 * pi), 1e-10);
  EXPECT_NEAR(distance_to_disk(0.0).slope, 0.5, 1e-15);
}

TEST(DiskQuality, DistanceToTheDiskIsItsMeanOverThePoints) {
  for (const double r : {0.1, 0.5, 0.9}) {
    double sum = 0.0;
    int count = 0;
    for (int x = -1000; x < 1000; ++x) {
      for (int y = -1000; y < 1000; ++y) {
        const glm::dvec2 q((x + 0.5) / 1000.0, (y + 0.5) / 1000.0);
        if (glm::dot(q, q) > 1.0) continue;
        sum += glm::distance(q, glm::dvec2(r, 0.0));
        ++count;
      }
    }
    EXPECT_NEAR(distance_to_disk(r * r).mean, sum / count, 1e-5);
    const double step = 1e-6;
    const double slope =
        (distance_to_disk(r * r + step).mean - distance_to_disk(r * r - step).mean) / (2 * step);
    EXPECT_NEAR(distance_to_disk(r * r).slope, slope, 1e-8);
  }
}

// Shirley and Chiu's map, forward, undoes ours; and equal areas stay equal.
TEST(DiskQuality, ConcentricMapIsInvertedAndPreservesArea) {
  int inside = 0;
  const int side = 400;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      const glm::dvec2 p(-1.0 + 2.0 * (x + 0.5) / side, -1.0 + 2.0 * (y + 0.5) / side);
      if (glm::dot(p, p) >= 1.0) continue;
      const glm::dvec2 square = 2.0 * square_from_disk(p) - 1.0;
      const bool steep = std::abs(square.y) > std::abs(square.x);
      const double radius = steep ? square.y : square.x;
      const double angle = steep ? pi / 2 - pi / 4 * square.x / square.y : pi / 4 * square.y / square.x;
      EXPECT_NEAR(radius * std::cos(angle), p.x, 1e-12);
      EXPECT_NEAR(radius * std::sin(angle), p.y, 1e-12);
      inside += square.x < 0.3 && square.y < -0.2 ? 1 : 0;
    }
  }
  EXPECT_NEAR(inside / (side * side * pi / 4.0), 0.65 * 0.4, 1e-3);
}

TEST(DiskQuality, StarDiscrepancyOfKnownSets) {
  // With one point in the middle, the closed box up to it holds everything in a quarter of the area.
  EXPECT_NEAR(disk_quality(DiskPoints{{0.0F, 0.0F}}).star_discrepancy, 0.75, 1e-12);
  // With one point in the square's upper right corner, every box short of it is empty.
  const auto corner = static_cast<float>(std::sqrt(0.5));
  EXPECT_NEAR(disk_quality(DiskPoints{{corner, corner}}).star_discrepancy, 1.0, 1e-6);
}

TEST(DiskQuality, RadialLawShowsTheBiasOfAnUncentredSpiral) {
  DiskPoints uncentred = fibonacci_directions(16);
  for (std::size_t i = 0; i < uncentred.size(); ++i) uncentred[i] *= std::sqrt(static_cast<float>(i) / 16.0F);
  EXPECT_NEAR(disk_quality(uncentred).radial_deviation, 1.0 / 16.0, 1e-6);
  EXPECT_NEAR(disk_quality(vogel_disk(16)).radial_deviation, 1.0 / 32.0, 1e-6);
}

TEST(DiskTables, DirectionsAreUnitAndAGoldenAngleApart) {
  const DiskPoints directions = fibonacci_directions(kFibonacciDirections);
  ASSERT_EQ(directions.size(), 64u);
  const double golden = std::cos(pi * (3.0 - std::sqrt(5.0)));
  for (std::size_t i = 0; i < directions.size(); ++i) {
    EXPECT_NEAR(glm::length(glm::dvec2(directions[i])), 1.0, 1e-7);
    if (i == 0) continue;
    EXPECT_NEAR(glm::dot(glm::dvec2(directions[i]), glm::dvec2(directions[i - 1])), golden, 2e-7);
  }
}

TEST(DiskTables, PoissonDisksAreCentredSpacedAndWithinTheDisk) {
  for (const int count : kPoissonSizes) {
    const DiskPoints points = poisson_disk(count);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(count));
    const DiskQuality quality = disk_quality(points);
    EXPECT_LT(quality.centroid, 0.002) << count;
    EXPECT_GT(quality.spacing, 1.5) << count;  // a random set has 0.3
    for (const auto& point : points) EXPECT_LT(glm::length(point), 1.0F);
  }
  EXPECT_TRUE(poisson_disk(26).empty());
}

// Tables in raster order have a trap: their first taps all lie on one side.
TEST(DiskTables, FirstSixteenTapsOfEveryPoissonDiskAreAFairDisk) {
  for (const int count : kPoissonSizes) {
    DiskPoints points = poisson_disk(count);
    points.resize(16);
    EXPECT_LT(disk_quality(points).centroid, 0.05) << count;
    EXPECT_LT(disk_quality(points).half_plane_rmse, 0.05) << count;
  }
}

std::string checked_in(const std::string& path) {
  std::ifstream file(PENUMBRA_SOURCE_DIR "/" + path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(DiskTables, CheckedInCopiesAreWhatIsEmitted) {
  const DiskSet set = disk_set(false);
  EXPECT_EQ(checked_in("ShaderLibrary/Core/DiskTables.hlsl"), disks_source(set, Language::hlsl));
  EXPECT_NE(disks_source(set, Language::csharp).find("public static readonly float[] Poisson128 ="),
            std::string::npos);
}

TEST(DiskTables, TableNamesEveryDisk) {
  const std::string table = disks_table(disk_set(false));
  EXPECT_NE(table.find("poisson        128"), std::string::npos);
  EXPECT_NE(table.find("fibonacci       64"), std::string::npos);
}

class DiskGenerator : public testing::TestWithParam<int> {};

TEST_P(DiskGenerator, MakesTheShippedDiskBitForBit) {
  EXPECT_EQ(generate_poisson_disk(GetParam()), poisson_disk(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Sizes, DiskGenerator, testing::ValuesIn(kPoissonSizes));

}  // namespace
}  // namespace penumbra::parameters
