#include "study/results.h"

#include <gtest/gtest.h>

namespace penumbra::study {
namespace {

TEST(Timing, MedianAndQuartileDistanceOfAnyOrder) {
  EXPECT_EQ(summarise({5.0, 1.0, 3.0, 2.0, 4.0}), (Timing{3.0, 2.0}));
  EXPECT_EQ(summarise({4.0, 1.0, 2.0, 3.0}), (Timing{2.5, 1.5}));
  EXPECT_EQ(summarise({7.0}), (Timing{7.0, 0.0}));
}

TEST(Timing, OneLateSampleMovesNeitherFigure) {
  EXPECT_EQ(summarise({1.0, 2.0, 3.0, 4.0, 500.0}), summarise({1.0, 2.0, 3.0, 4.0, 5.0}));
}

TEST(Timing, NothingTimedIsAbsent) {
  EXPECT_EQ(summarise(std::vector<double>{}), std::nullopt);
}

}  // namespace
}  // namespace penumbra::study
