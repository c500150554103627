#include "study/interval.h"

#include <gtest/gtest.h>

namespace penumbra::study {
namespace {

Estimate estimate(double value, double half) {
  return {value, Interval{value - half, value + half, half / 2.0}};
}

TEST(FigureText, EndsWhereItsIntervalDoes) {
  EXPECT_EQ(figure_text(estimate(0.14712, 0.0312)), "0.147 ± 0.031");
  EXPECT_EQ(figure_text(estimate(0.14712, 0.0042)), "0.147 ± 0.004");
  EXPECT_EQ(figure_text(estimate(0.14712, 0.0012)), "0.1471 ± 0.0012");
  EXPECT_EQ(figure_text(estimate(0.14712, 0.12)), "0.15 ± 0.12");
  EXPECT_EQ(figure_text(estimate(28.61, 3.2)), "28.6 ± 3.2");
  EXPECT_EQ(figure_text(estimate(28.61, 12.4)), "29 ± 12");
}

TEST(FigureText, AHalfWidthThatRoundsUpKeepsTwoDigits) {
  EXPECT_EQ(figure_text(estimate(0.5, 0.0996)), "0.50 ± 0.10");
  EXPECT_EQ(figure_text(estimate(40.0, 9.7)), "40 ± 10");
  EXPECT_EQ(figure_text(estimate(0.5, 0.036)), "0.50 ± 0.04");
}

TEST(FigureText, AnIntervalThatABoundCutsOffStandsWithBothEnds) {
  EXPECT_EQ(figure_text(Estimate{0.07, Interval{0.0, 0.17, 0.05}}), "0.07 [0, 0.17]");
  EXPECT_EQ(figure_text(Estimate{0.07, Interval{0.0, 0.17, 0.05}}, 100.0), "7 [0, 17]");
  EXPECT_EQ(figure_text(Estimate{0.95, Interval{0.883, 1.0, 0.03}}), "0.95 [0.88, 1]");
}

TEST(FigureText, TheLongerSideGivesTheDigits) {
  EXPECT_EQ(figure_text(Estimate{0.01, Interval{0.0, 0.033, 0.013}}), "0.010 [0, 0.033]");
  EXPECT_EQ(figure_text(Estimate{0.1, Interval{0.099, 0.13, 0.01}}), "0.100 ± 0.030")
      << "no bound cuts this one off";
}

TEST(FigureText, PercentIsScaledFirst) {
  EXPECT_EQ(figure_text(estimate(0.0431, 0.012), 100.0), "4.3 ± 1.2");
}

TEST(FigureText, WithoutAWidthItStandsAlone) {
  EXPECT_EQ(figure_text(estimate(4.0, 0.0)), "4");
  EXPECT_EQ(figure_text(estimate(0.0, 0.0), 100.0), "0");
  EXPECT_EQ(figure_text(Estimate{0.14712, std::nullopt}), "0.147");
  EXPECT_EQ(figure_text(Estimate{28.57, std::nullopt}), "28.6");
  EXPECT_EQ(figure_text(std::nullopt), "–");
}

TEST(FigureText, FetchesHaveATenthAtMost) {
  EXPECT_EQ(fetches_text(estimate(39.99968, 0.0004)), "40.0");
  EXPECT_EQ(fetches_text(estimate(28.5671, 0.31)), "28.6 ± 0.3");
  EXPECT_EQ(fetches_text(estimate(28.5671, 0.04)), "28.6");
}

}  // namespace
}  // namespace penumbra::study
