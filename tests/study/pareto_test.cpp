#include "study/report_charts.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

namespace penumbra::study {
namespace {

using testing::ElementsAre;

bool dominates(const CostAndError& a, const CostAndError& b) {
  return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

TEST(ParetoFront, IsEveryPointNothingDominates) {
  std::mt19937 random(11);
  for (int round = 0; round < 500; ++round) {
    // Few distinct values, so that ties and twins occur in every round.
    std::uniform_int_distribution<int> small(0, 6);
    std::vector<CostAndError> points(static_cast<std::size_t>(round % 25));
    for (CostAndError& point : points) point = {small(random) * 1.0, small(random) * 0.125};
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool stands = true;
      for (const CostAndError& other : points) stands = stands && !dominates(other, points[i]);
      if (stands) expected.push_back(i);
    }
    const std::vector<std::size_t> front = pareto_front(points);
    EXPECT_THAT(front, testing::UnorderedElementsAreArray(expected));
    for (std::size_t i = 1; i < front.size(); ++i) {
      EXPECT_LE(points[front[i - 1]].cost, points[front[i]].cost);
    }
  }
}

TEST(ParetoFront, WhatIsNoNumberNeverStands) {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(pareto_front({{nan, 0.0}, {1.0, nan}, {2.0, 0.5}, {0.0, infinity}, {-infinity, 0.0}}),
              ElementsAre(2));
  EXPECT_THAT(pareto_front({}), ElementsAre());
}

}  // namespace
}  // namespace penumbra::study
