#include "study/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace penumbra::study {
namespace {

constexpr int kSeamWidth = 2 * kSeamBlock;
constexpr int kSeamHeight = 2 * kSeamBlock;

// The columns left of the border read cascade 0, the others 1.
struct SeamFrame {
  std::vector<int> cascade = std::vector<int>(kSeamWidth * kSeamHeight, 0);
  std::vector<float> t1 = std::vector<float>(kSeamWidth * kSeamHeight, 0.5F);
  std::vector<float> result = std::vector<float>(kSeamWidth * kSeamHeight, 0.5F);

  explicit SeamFrame(int border) {
    for (int i = 0; i < kSeamWidth * kSeamHeight; ++i)
      cascade[static_cast<std::size_t>(i)] = i % kSeamWidth < border ? 0 : 1;
  }
  float& at(std::vector<float>& image, int x, int y) {
    return image[static_cast<std::size_t>(y * kSeamWidth + x)];
  }
  Seam seam() const { return seam_of({kSeamWidth, cascade, t1, result}); }
};

TEST(Seam, IsTheChangeOfErrorAcrossTheBorder) {
  SeamFrame frame(5);
  for (int y = 0; y < kSeamHeight; ++y)
    for (int x = 5; x < kSeamWidth; ++x) frame.at(frame.result, x, y) = 0.75F;
  const Seam seam = frame.seam();
  EXPECT_EQ(seam.pairs, std::size_t{kSeamHeight});
  EXPECT_NEAR(*seam.step, 0.25, 1e-7);
  EXPECT_NEAR(*seam.elsewhere, 0.0, 1e-7);
}

TEST(Seam, AChangeOfTheReferenceIsNoError) {
  SeamFrame frame(5);
  for (int y = 0; y < kSeamHeight; ++y)
    for (int x = 5; x < kSeamWidth; ++x) frame.at(frame.result, x, y) = frame.at(frame.t1, x, y) = 0.75F;
  EXPECT_NEAR(*frame.seam().step, 0.0, 1e-7);
}

TEST(Seam, NoiseAveragesOutAlongTheBorder) {
  SeamFrame frame(5);
  for (int y = 0; y < kSeamHeight; ++y) frame.at(frame.result, 5, y) += y % 2 == 0 ? 0.2F : -0.2F;
  EXPECT_NEAR(*frame.seam().step, 0.0, 1e-7);
}

// The sign is that of the way away from the camera, whichever side the next cascade is on.
TEST(Seam, HasTheSignOfTheWayToTheNextCascade) {
  SeamFrame frame(0);  // cascade 1 is everywhere but in columns 8 to 11: two borders in one block
  for (int y = 0; y < kSeamHeight; ++y)
    for (int x = 8; x < 12; ++x) {
      frame.cascade[static_cast<std::size_t>(y * kSeamWidth + x)] = 0;
      frame.at(frame.result, x, y) = 0.4F;
    }
  EXPECT_NEAR(*frame.seam().step, 0.1, 1e-7);
  EXPECT_EQ(frame.seam().pairs, std::size_t{2 * kSeamHeight});
}

TEST(Seam, CountsPenumbraPixelsThatHaveACascade) {
  SeamFrame frame(5);
  for (int y = 0; y < kSeamHeight; ++y) frame.at(frame.result, 4, y) = 0.9F;
  for (int y = 0; y < kSeamHeight / 2; ++y) frame.at(frame.t1, 4, y) = 1.0F;
  EXPECT_EQ(frame.seam().pairs, std::size_t{kSeamHeight / 2});
  for (int y = kSeamHeight / 2; y < kSeamHeight; ++y)
    frame.cascade[static_cast<std::size_t>(y * kSeamWidth + 4)] = -1;
  EXPECT_EQ(frame.seam().pairs, 0U);
  EXPECT_FALSE(frame.seam().step);
}

TEST(Seam, LeavesOutBlocksWithFewPairs) {
  SeamFrame frame(kSeamWidth);
  for (int y = 0; y < kSeamPairs - 1; ++y) frame.cascade[static_cast<std::size_t>(y * kSeamWidth)] = 1;
  // The vertical pairs beside them count, too: one below the last.
  for (int y = 0; y < kSeamPairs - 1; ++y) frame.at(frame.t1, 0, y) = y == 0 ? 0.5F : 0.0F;
  EXPECT_EQ(frame.seam().pairs, 0U);
}

TEST(Seam, MeasuresTheSlopeOfTheErrorElsewhere) {
  SeamFrame frame(kSeamWidth);
  for (int y = 0; y < kSeamHeight; ++y)
    for (int x = 0; x < kSeamWidth; ++x) frame.at(frame.result, x, y) = 0.5F + 0.01F * static_cast<float>(y);
  EXPECT_NEAR(*frame.seam().elsewhere, 0.01, 1e-6);
}

TEST(Seam, RefusesImagesOfDifferentSizes) {
  SeamFrame frame(5);
  frame.t1.pop_back();
  EXPECT_THROW(frame.seam(), std::invalid_argument);
}

// Groups of 8 x 8 pixels that each have an error of their own step at their borders alone; an error that
// rises evenly steps everywhere.
TEST(GroupStep, IsTheStepAtBordersOfGroupsBesideThatWithinThem) {
  SeamFrame groups(kSeamWidth), slope(kSeamWidth);
  std::size_t pairs = 0;
  for (int y = 0; y < kSeamHeight; ++y)
    for (int x = 0; x < kSeamWidth; ++x) {
      groups.at(groups.result, x, y) += (x / kGroupPixels + y / kGroupPixels) % 2 == 0 ? 0.0F : 0.25F;
      slope.at(slope.result, x, y) += 0.001F * static_cast<float>(x + y);
      pairs += (x > 0 && x % kGroupPixels == 0 ? 1U : 0U) + (y > 0 && y % kGroupPixels == 0 ? 1U : 0U);
    }
  const GroupStep blocks = group_step_of({kSeamWidth, groups.cascade, groups.t1, groups.result});
  EXPECT_EQ(blocks.pairs, pairs);
  EXPECT_NEAR(*blocks.across, 0.25, 1e-7);
  EXPECT_NEAR(*blocks.inside, 0.0, 1e-7);
  const GroupStep even = group_step_of({kSeamWidth, slope.cascade, slope.t1, slope.result});
  EXPECT_NEAR(*even.across, 0.001, 1e-6);
  EXPECT_NEAR(*even.inside, 0.001, 1e-6);
}

// Neither lit pixels nor pairs of two cascades count.
TEST(GroupStep, CountsPenumbraeOfOneCascade) {
  SeamFrame frame(kGroupPixels);
  for (int x = 0; x < kSeamWidth; ++x)
    for (int y = kGroupPixels; y < kSeamHeight; ++y) frame.at(frame.t1, x, y) = 1.0F;
  const GroupStep step = group_step_of({kSeamWidth, frame.cascade, frame.t1, frame.result});
  EXPECT_EQ(step.pairs, static_cast<std::size_t>((kSeamWidth / kGroupPixels - 2) * kGroupPixels));
  EXPECT_THROW(group_step_of({kSeamWidth - 1, frame.cascade, frame.t1, frame.result}), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::study
