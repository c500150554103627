#include "study/interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace penumbra::study {
namespace {

constexpr double kNoBound = 1e300;

// The share of `repetitions` intervals that hold the truth.
double coverage(int repetitions, double truth, const std::function<std::optional<Interval>()>& draw) {
  int hits = 0;
  for (int k = 0; k < repetitions; ++k) {
    const std::optional<Interval> interval = draw();
    hits += interval->low <= truth && truth <= interval->high ? 1 : 0;
  }
  return static_cast<double>(hits) / repetitions;
}

// The picture has 80 blocks with 20 to 60 pixels each. Pixels of one block err alike: the block's own error
// has the standard deviation 0.1, and the pixel's 0.05. The true RMSE is the root of 0.1^2 + 0.05^2.
TEST(BlockInterval, HoldsTheTruthAsOftenAsItSays) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const double share = coverage(400, std::sqrt(0.0125), [&] {
    std::vector<BlockSums> blocks(80);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const double common = 0.1 * normal(random);
      for (std::size_t pixel = 0; pixel < 20 + i % 41; ++pixel) {
        const double error = common + 0.05 * normal(random);
        blocks[i].sum += error * error;
        blocks[i].count += 1.0;
      }
    }
    return block_interval(blocks, Figure::root_of_mean, 1.0);
  });
  EXPECT_GE(share, 0.88);
  EXPECT_LE(share, 0.99);
}

// Twelve blocks are few: twice the replicates' deviation as it stands would hold the truth too seldom.
TEST(BlockInterval, HoldsTheTruthWithFewBlocks) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform;
  const double share = coverage(400, 0.5, [&] {
    std::vector<BlockSums> blocks(12);
    for (BlockSums& block : blocks) block = {10.0 * uniform(random), 10.0};
    return block_interval(blocks, Figure::mean, 1.0);
  });
  EXPECT_GE(share, 0.90);
  EXPECT_LE(share, 0.99);
}

// The scenes are out of many, whose true figures differ by 0.04, and each is measured to 0.01.
class MeanCoverage : public testing::TestWithParam<std::size_t> {};

TEST_P(MeanCoverage, HoldsTheTruthAsOftenAsItSays) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  const double share = coverage(400, 0.3, [&] {
    std::vector<SceneFigure> scenes(GetParam());
    for (SceneFigure& scene : scenes) {
      scene = {0.3 + 0.04 * normal(random) + 0.01 * normal(random), 0.01};
    }
    return mean_interval(scenes, 0.0, 1.0);
  });
  EXPECT_GE(share, 0.90);
  EXPECT_LE(share, 0.99);
}

INSTANTIATE_TEST_SUITE_P(Scenes, MeanCoverage, testing::Values(3U, 4U, 8U));

TEST(MeanInterval, CountsBothLevels) {
  const std::vector<SceneFigure> alike(8, SceneFigure{0.3, 0.04});
  const Interval pixels = mean_interval(alike, 0.0, 1.0).value();
  EXPECT_NEAR(pixels.standard_error, 0.04 / std::sqrt(7.0), 1e-12) << "what the scenes' own errors leave";
  std::vector<SceneFigure> different(8, SceneFigure{0.3, 0.0});
  for (std::size_t k = 0; k < different.size(); ++k) different[k].value += k % 2 == 0 ? 0.05 : -0.05;
  EXPECT_NEAR(mean_interval(different, 0.0, 1.0)->standard_error, 0.05 / std::sqrt(7.0), 1e-12);
}

// One scene of eleven is an outlier, which few draws take too seldom or too often.
TEST(MeanInterval, IsWhatManyDrawsApproach) {
  std::vector<SceneFigure> scenes(11, SceneFigure{0.02, 0.01});
  scenes[4] = {0.6, 0.05};
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> any(0, scenes.size() - 1);
  std::normal_distribution<double> normal;
  constexpr int kDraws = 200'000;
  double sum = 0.0, squares = 0.0;
  for (int draw = 0; draw < kDraws; ++draw) {
    double mean = 0.0;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      const SceneFigure& scene = scenes[any(random)];
      mean += (scene.value + scene.standard_error * normal(random)) / static_cast<double>(scenes.size());
    }
    sum += mean;
    squares += mean * mean;
  }
  const double variance = squares / kDraws - (sum / kDraws) * (sum / kDraws);
  EXPECT_NEAR(mean_interval(scenes, 0.0, 1.0)->standard_error / std::sqrt(1.1 * variance), 1.0, 0.01);
}

// The linearised error of a ratio of sums, and of its root (Cochran, "Sampling Techniques", section 6.3).
TEST(BlockInterval, IsNearTheLinearisedOne) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> uniform;
  std::vector<BlockSums> blocks(300);
  BlockSums all;
  for (BlockSums& block : blocks) {
    block = {40.0 * std::pow(uniform(random), 6.0), 20.0 + 20.0 * uniform(random)};
    all.sum += block.sum;
    all.count += block.count;
  }
  const double mean = all.sum / all.count;
  double squares = 0.0;
  for (const BlockSums& block : blocks) squares += std::pow(block.sum - mean * block.count, 2.0);
  const double error = std::sqrt(squares * 300.0 / 299.0) / all.count;
  EXPECT_NEAR(block_interval(blocks, Figure::mean, kNoBound)->standard_error / error, 1.0, 0.07);
  EXPECT_NEAR(
      block_interval(blocks, Figure::root_of_mean, kNoBound)->standard_error * 2.0 * std::sqrt(mean) / error,
      1.0, 0.07);
}

TEST(MeanInterval, FewerScenesAreLessSure) {
  const std::vector<SceneFigure> four{{0.2, 0}, {0.3, 0}, {0.2, 0}, {0.3, 0}};
  std::vector<SceneFigure> eight = four;
  eight.insert(eight.end(), four.begin(), four.end());
  const Interval few = mean_interval(four, 0.0, 1.0).value();
  const Interval many = mean_interval(eight, 0.0, 1.0).value();
  EXPECT_GT(few.high - few.low, 1.3 * (many.high - many.low));
}

TEST(Intervals, TheSameFiguresGiveTheSameBytes) {
  const std::vector<BlockSums> blocks{{1.0, 4.0}, {2.0, 4.0}, {0.5, 3.0}};
  EXPECT_EQ(block_interval(blocks, Figure::mean, 1.0), block_interval(blocks, Figure::mean, 1.0));
  const std::vector<SceneFigure> scenes{{0.1, 0.01}, {0.2, 0.02}};
  EXPECT_EQ(mean_interval(scenes, 0.0, 1.0), mean_interval(scenes, 0.0, 1.0));
}

TEST(Intervals, StayInsideTheFiguresRangeAndHoldTheFigure) {
  const std::vector<SceneFigure> rare{{0.001, 0.01}, {0.0, 0.0}, {0.002, 0.01}};
  const Interval interval = mean_interval(rare, 0.0, 1.0).value();
  EXPECT_GE(interval.low, 0.0);
  EXPECT_LE(interval.low, 0.001);
  EXPECT_GE(interval.high, 0.001);
  const std::vector<BlockSums> all{{4.0, 4.0}, {3.9, 4.0}, {4.0, 4.0}};
  EXPECT_EQ(block_interval(all, Figure::mean, 1.0)->high, 1.0);
}

TEST(Intervals, OneBlockOrNothingHasNone) {
  EXPECT_FALSE(block_interval(std::vector<BlockSums>{{3.0, 4.0}, {0.0, 0.0}}, Figure::mean, 1.0));
  EXPECT_FALSE(block_interval(std::vector<BlockSums>{}, Figure::mean, 1.0));
  EXPECT_FALSE(mean_interval(std::vector<SceneFigure>{}, 0.0, kNoBound));
  EXPECT_FALSE(mean_interval(std::vector<SceneFigure>{{0.3, 0.0}}, 0.0, kNoBound));
}

TEST(Intervals, OneSceneIsAsSureAsItself) {
  const Interval interval = mean_interval(std::vector<SceneFigure>{{0.3, 0.01}}, 0.0, 1.0).value();
  EXPECT_NEAR(interval.low, 0.3 - 0.0196, 1e-4);
  EXPECT_NEAR(interval.high, 0.3 + 0.0196, 1e-4);
}

}  // namespace
}  // namespace penumbra::study
