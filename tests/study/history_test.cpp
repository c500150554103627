// Compares the exponential mean of frames with the weights that it gives to each of them.
#include "study/study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace penumbra::study {
namespace {

TEST(History, IsTheFrameItselfWhereTheNewestIsAll) {
  EXPECT_EQ(history_frames(1.0, 3), 3);
  const std::vector<std::vector<float>> frames{{0.25F, 1.0F}, {0.5F, 0.0F}, {0.75F, 0.125F}};
  EXPECT_EQ(histories(frames, 1.0, 3), frames);
}

// A frame n frames back counts share (1 - share)^n; the first one counts what is left of the sum.
TEST(History, WeighsFramesByTheirAge) {
  for (const double share : {0.05, 0.1, 0.5}) {
    const int results = 3;
    const int count = history_frames(share, results);
    const int apart = history_frames(share, 2) - history_frames(share, 1);
    for (int lit = 0; lit < count; ++lit) {
      std::vector<std::vector<float>> frames(static_cast<std::size_t>(count), {0.0F});
      frames[static_cast<std::size_t>(lit)] = {1.0F};
      const std::vector<std::vector<float>> found = histories(frames, share, results);
      ASSERT_EQ(found.size(), 3U);
      for (int result = 0; result < results; ++result) {
        const int age = count - 1 - apart * (results - 1 - result) - lit;
        const double expected = age < 0 ? 0.0 : (lit == 0 ? 1.0 : share) * std::pow(1.0 - share, age);
        EXPECT_NEAR(found[static_cast<std::size_t>(result)][0], expected, 1e-7) << lit << " of " << count;
      }
    }
  }
}

TEST(History, HasForgottenItsFirstFrame) {
  for (const double share : {0.01, 0.1, 0.3, 0.9}) {
    const int count = history_frames(share, 1);
    EXPECT_LE(std::pow(1.0 - share, count - 1), 0.01) << share;
    EXPECT_GT(std::pow(1.0 - share, count - 2), 0.01) << share;
  }
}

TEST(History, RefusesOtherSharesAndNumbersOfFrames) {
  EXPECT_THROW(history_frames(0.0, 1), std::invalid_argument);
  EXPECT_THROW(history_frames(1.5, 1), std::invalid_argument);
  EXPECT_THROW(history_frames(std::nan(""), 1), std::invalid_argument);
  EXPECT_THROW(histories({{0.0F}}, 0.5, 1), std::invalid_argument);
  std::vector<std::vector<float>> uneven(static_cast<std::size_t>(history_frames(0.5, 1)), {0.0F});
  uneven.back() = {0.0F, 1.0F};
  EXPECT_THROW(histories(uneven, 0.5, 1), std::invalid_argument);
}

}  // namespace
}  // namespace penumbra::study
